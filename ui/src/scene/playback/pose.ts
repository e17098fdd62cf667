/** A wire laid as the Rust side says: nothing here knows how a wire bends. */

import { MathUtils, Quaternion, Vector3 } from "three";
import type { Pose, Vec3 } from "../interface";
import { subtract } from "../vec";

/** From the frame of the design to that of the machine when so much of the step's bend is done, from 0 to 1. */
export function turned({ turn, bendAxis, bend }: Pose, bent: number): Quaternion {
  const about = new Quaternion().setFromAxisAngle(new Vector3(...bendAxis), MathUtils.degToRad(bend) * bent);
  return about.multiply(new Quaternion(...turn));
}

/** Where a place is once `origin` lies at the bend point. */
export function placed(turn: Quaternion, origin: Vec3, at: Vec3): Vec3 {
  const { x, y, z } = new Vector3(...subtract(at, origin)).applyQuaternion(turn);
  return [x, y, z];
}
