/** Takes what stands in the field that has the focus, as if it had lost it: what is typed there belongs to what is saved. */
export function takeTyped(): void {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement || field instanceof HTMLTextAreaElement)) return;
  field.blur();
  field.focus();
}
