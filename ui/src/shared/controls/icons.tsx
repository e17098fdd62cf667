import type { ReactNode } from "react";

/** 16 units square, drawn with lines in the colour of the text. */
const drawings = {
  select: <path d="M4 2.5 12.5 8 8.6 8.9 11 13.2 9.3 14 7 9.7 4 12.4z" />,
  trace: <path d="M2.5 13.5l.8-3 7.7-7.7a1.3 1.3 0 0 1 1.8 0l.4.4a1.3 1.3 0 0 1 0 1.8L5.5 12.7zM9.6 4.2l2.2 2.2" />,
  draw: (
    <>
      <path d="M1.5 11.5 5 4.5h9.5L11 11.5zM5 11.5 8.5 4.5M3.2 8h9.6" />
    </>
  ),
  measure: <path d="M10.8 1.8 14.2 5.2 5.2 14.2 1.8 10.8zM4 8.6l1.5 1.5M6.3 6.3l2.2 2.2M8.6 4l1.5 1.5" />,
  move: (
    <path d="M8 1.5v13M1.5 8h13M6.3 3.2 8 1.5l1.7 1.7M6.3 12.8 8 14.5l1.7-1.7M3.2 6.3 1.5 8l1.7 1.7M12.8 6.3 14.5 8l-1.7 1.7" />
  ),
  extrude: (
    <>
      <path d="M3 13.5V9.8M3 9.8 11.3 4.4M8.6 3.2l3.3.8-.8 3.3" />
      <circle cx="3" cy="12.3" r="1.6" fill="currentColor" />
    </>
  ),
  split: (
    <>
      <path d="M1.8 13.2 6.4 9M9.6 6.6l4.6-4" />
      <circle cx="8" cy="7.8" r="2" />
      <path d="M4.4 4.2 11.8 12" strokeDasharray="1.6 1.8" />
    </>
  ),
  merge: <path d="M2 3.5 7 8l-5 4.5M14 3.5 9 8l5 4.5M4.2 8H2M11.8 8H14" />,
  connect: (
    <>
      <circle cx="3.5" cy="12" r="2" />
      <circle cx="12.5" cy="4" r="2" />
      <path d="M5.2 10.7 10.8 5.3" strokeDasharray="2 1.7" />
    </>
  ),
  mirror: <path d="M8 1.5v13M6 4 1.8 12H6zM10 4l4.2 8H10z" />,
  help: (
    <>
      <path d="M5.6 6a2.4 2.4 0 1 1 3.6 2.1c-.8.5-1.2.9-1.2 1.9" />
      <circle cx="8" cy="12.6" r=".5" fill="currentColor" />
    </>
  ),
  undo: <path d="M5.5 3 2.5 6l3 3M2.5 6h6.8a3.7 3.7 0 0 1 0 7.4H6" />,
  redo: <path d="M10.5 3l3 3-3 3M13.5 6H6.7a3.7 3.7 0 0 0 0 7.4H10" />,
  play: <path d="M4.5 2.8v10.4L13 8z" fill="currentColor" />,
  pause: <path d="M5 3v10M11 3v10" strokeWidth="2.4" />,
  previous: <path d="M12.5 3v10L5 8zM3.5 3v10" fill="currentColor" />,
  next: <path d="M3.5 3v10L11 8zM12.5 3v10" fill="currentColor" />,
  reset: <path d="M13 8a5 5 0 1 1-1.6-3.7M13 2v3.2H9.8" />,
  right: <path d="M6 3.5 10.5 8 6 12.5" />,
  down: <path d="M3.5 6 8 10.5 12.5 6" />,
  up: <path d="M3.5 10 8 5.5 12.5 10" />,
  fine: (
    <>
      <circle cx="8" cy="8" r="6" />
      <path d="M5.2 8.2 7.2 10.2 11 6" />
    </>
  ),
  error: (
    <>
      <path d="M5.5 2h5L14 5.5v5L10.5 14h-5L2 10.5v-5z" fill="currentColor" />
      <path d="M5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4" stroke="var(--panel)" />
    </>
  ),
  warning: (
    <>
      <path d="M8 2.2 14.5 13.3h-13z" />
      <path d="M8 6.4v3.2M8 11.4v.2" />
    </>
  ),
  info: (
    <>
      <circle cx="8" cy="8" r="6" />
      <path d="M8 7.4v3.6M8 5v.2" />
    </>
  ),
  check: <path d="M3 8.5 6.3 11.8 13 4.5" />,
  close: <path d="M3.5 3.5l9 9M12.5 3.5l-9 9" />,
  folder: <path d="M1.8 12.8V3.4h4.4l1.6 1.8h6.4v7.6z" />,
  file: <path d="M3.5 1.8h6l3 3v9.4h-9zM9.3 1.8v3.2h3.2" />,
  save: <path d="M2.5 2.5h8.8l2.2 2.2v8.8h-11zM5 2.5v3.6h5V2.5M4.8 13.5V9.2h6.4v4.3" />,
  shown: (
    <>
      <path d="M1.3 8S3.7 3.5 8 3.5 14.7 8 14.7 8 12.3 12.5 8 12.5 1.3 8 1.3 8z" />
      <circle cx="8" cy="8" r="2" />
    </>
  ),
  hidden: (
    <>
      <path d="M1.3 8S3.7 3.5 8 3.5 14.7 8 14.7 8 12.3 12.5 8 12.5 1.3 8 1.3 8z" />
      <path d="M2.8 13.2 13.2 2.8" />
    </>
  ),
  plus: <path d="M8 2.8v10.4M2.8 8h10.4" />,
  minus: <path d="M2.8 8h10.4" />,
  trash: <path d="M2.8 4.3h10.4M6 4.3V2.5h4v1.8M4.3 4.3l.6 9.2h6.2l.6-9.2M6.7 7v4M9.3 7v4" />,
  copy: <path d="M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3" />,
  search: (
    <>
      <circle cx="7" cy="7" r="4.3" />
      <path d="M10.2 10.2l3.6 3.6" />
    </>
  ),
  stop: <path d="M5.5 2h5L14 5.5v5L10.5 14h-5L2 10.5v-5z" fill="currentColor" />,
  home: <path d="M2 7.8 8 2.5l6 5.3M3.8 6.8v6.7h8.4V6.8M6.6 13.5V9.6h2.8v3.9" />,
  machine: <path d="M1.8 13.2h12.4M3.5 13.2V7.5h5v5.7M8.5 9.3h5.7M3.5 7.5V4.2h2.8v3.3M11.2 6.4a3 3 0 0 1 2.6 2.9" />,
  wire: <path d="M1.5 12.5h4.3L8.6 4.2h5.9" />,
  record: <circle cx="8" cy="8" r="4.5" fill="currentColor" />,
  frame: <path d="M2.2 5.4V2.2h3.2M10.6 2.2h3.2v3.2M13.8 10.6v3.2h-3.2M5.4 13.8H2.2v-3.2" />,
  lock: <path d="M3.5 7.2h9v6.3h-9zM5.4 7.2V5a2.6 2.6 0 0 1 5.2 0v2.2" />,
  more: (
    <>
      <circle cx="3.5" cy="8" r=".9" fill="currentColor" />
      <circle cx="8" cy="8" r=".9" fill="currentColor" />
      <circle cx="12.5" cy="8" r=".9" fill="currentColor" />
    </>
  ),
} satisfies Record<string, ReactNode>;

export type IconName = keyof typeof drawings;

/** A drawing beside a word, or in a button that has a name of its own: hidden from screen readers. Size in px. */
export function Icon({ name, size = 16 }: { name: IconName; size?: 16 | 20 | 12 }) {
  return (
    <svg
      className="icon"
      width={size}
      height={size}
      viewBox="0 0 16 16"
      fill="none"
      stroke="currentColor"
      strokeWidth="1.4"
      strokeLinecap="round"
      strokeLinejoin="round"
      aria-hidden="true"
      focusable="false"
    >
      {drawings[name]}
    </svg>
  );
}
