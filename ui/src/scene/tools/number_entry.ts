/** A number that is typed while something is moved. */

export class NumberEntry {
  text = "";
  private negative = false;

  /** Whether the key belonged to the number. Names as `KeyboardEvent.key` has them. */
  key(key: string): boolean {
    if (/^[0-9]$/.test(key)) this.text += key;
    else if (key === "." || key === ",") this.text += this.text.includes(".") ? "" : this.text === "" ? "0." : ".";
    else if (key === "-") this.negative = !this.negative;
    else if (key === "Backspace") this.backspace();
    else return false;
    return true;
  }

  /** Null while no digit has been typed. */
  get value(): number | null {
    if (this.text === "") return null;
    const size = Number(this.text);
    return this.negative ? -size : size;
  }

  /** As it is shown; empty where nothing was typed. */
  get shown(): string {
    return (this.negative ? "−" : "") + this.text;
  }

  clear(): void {
    this.text = "";
    this.negative = false;
  }

  private backspace(): void {
    if (this.text === "") this.negative = false;
    this.text = this.text.slice(0, -1);
  }
}
