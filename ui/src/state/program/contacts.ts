/** Where the wire that is played hits something: the collisions that Check knows, as moments of the program. */

import { create } from "zustand";
import type { ContactReport } from "../../generated/responses";
import type { Touch } from "../../scene/interface";
import { isCurrent } from "../design/collisions";
import { useDesign } from "../design/design";
import { useMachines } from "../machine/machines";
import { store, stored } from "../window/ui";
import { isUpToDate, usePlayback, useProgram, useStale } from "./program";
import { useRunFile } from "./run_file";

/** A collision, and where in the program it is: its step with the part of it that has passed. */
export interface PlayedContact extends ContactReport {
  readonly position: number;
}

/** Less than a picture shows. */
const NEAR = 1e-6;

const NONE: readonly PlayedContact[] = [];

/** Of the same answer the same ones. */
const sorted = new WeakMap<readonly ContactReport[], readonly PlayedContact[]>();

function played(contacts: readonly ContactReport[]): readonly PlayedContact[] {
  const before = sorted.get(contacts);
  if (before) return before;
  // The end of a step is the beginning of the next, where it would look like one of that.
  const all = contacts.map((contact) => ({ ...contact, position: contact.step + Math.min(contact.at, 1 - NEAR) }));
  const inOrder = all.toSorted((a, b) => a.position - b.position);
  sorted.set(contacts, inOrder);
  return inOrder;
}

/** What is not there yet of the design as it is: what is found there, or the program in which it is. */
export type Missing = "collisions" | "program";

function missing(upToDate: boolean): Missing | null {
  const { collisions } = useDesign.getState();
  if (!collisions || !isCurrent(collisions) || collisions.dragged) return "collisions";
  return upToDate ? null : "program";
}

/** Those of all wires of the program; none where they are of another design than it is. */
function ofProgram(upToDate: boolean): readonly PlayedContact[] {
  const { collisions } = useDesign.getState();
  // They are those of the design.
  if (!collisions || useRunFile.getState().file || missing(upToDate)) return NONE;
  return played(collisions.found.contacts);
}

/** Those of the wire that is shown, in their order. */
const contactsNow = (): readonly PlayedContact[] => {
  const { wire } = useProgram.getState();
  return ofProgram(isUpToDate()).filter((contact) => contact.wire === wire);
};

/** How often wires hit something, and how often they only come nearer than the clearance. */
export interface Met {
  readonly hits: number;
  readonly near: number;
}

interface Contacts {
  readonly missing: Missing | null;
  /** Of the wire that is shown. */
  readonly contacts: readonly PlayedContact[];
  /** How many the others have. */
  readonly elsewhere: Met;
}

/** The same for what is drawn anew when they change. */
export function useContacts(): Contacts {
  useDesign(({ collisions }) => collisions);
  useDesign(({ version }) => version);
  useMachines(({ changes }) => changes);
  useRunFile();
  const wire = useProgram((program) => program.wire);
  const upToDate = !useStale();
  const all = ofProgram(upToDate);
  const contacts = all.filter((contact) => contact.wire === wire);
  const hits = hitsOf(all).length - hitsOf(contacts).length;
  const elsewhere = { hits, near: all.length - contacts.length - hits };
  return { missing: missing(upToDate), contacts, elsewhere };
}

/** Those at which something is hit: others only come nearer than the clearance. */
const hitsOf = (contacts: readonly PlayedContact[]) => contacts.filter(({ depth_mm }) => depth_mm >= 0);

/** The collisions of the step that is under way that have happened at a position, the last one first. */
export function metAt(contacts: readonly PlayedContact[], position: number): readonly PlayedContact[] {
  const step = Math.floor(position);
  return contacts.filter((one) => one.step === step && one.position <= position + NEAR).toReversed();
}

/** What touches what at the position that is shown. */
export function touchesNow(): readonly Touch[] {
  const { played: shown, step } = usePlayback.getState();
  if (!shown) return [];
  return metAt(hitsOf(contactsNow()), step).map(({ leg, body }) => ({ leg, body }));
}

const KEY = "wirebend.stop-at-collisions";

/** Whether playing pauses where the wire hits something. */
export const useStops = create<{ readonly on: boolean }>()(() => ({ on: stored(KEY) !== "false" }));

export function setStops(on: boolean): void {
  useStops.setState({ on });
  store(KEY, String(on));
}

/** Where playing from one position to another pauses; null where it goes on. */
export function stopBetween(from: number, to: number): number | null {
  if (!useStops.getState().on) return null;
  const next = hitsOf(contactsNow()).find(({ position }) => position > from + NEAR && position <= to);
  return next?.position ?? null;
}
