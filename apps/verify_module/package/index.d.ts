/** What is asked of a program; README.md describes every key. */
export interface Question {
  /** Name of the program in messages and in the certificate. */
  name?: string;
  /** Control that runs the program: "grbl", "linuxcnc", "fanuc", ...; absent: recognised. */
  dialect?: string;
  /** Tools, each as in "endmill:6:T1". */
  tools?: string[];
  /** The part as outline JSON; absent: the program is checked alone. */
  part?: object;
  /** Without a part: the block, "X,Y,Z" or each as "LOW:HIGH", mm. */
  stock?: string;
  /** Without a part: height of the material's top, mm. */
  top?: number;
  /** Name of a known machine, the settings of a control as text (Grbl's `$$`), or the keys of a machine file. */
  machine?: string|object;
  /** Options of `clearcut verify` by their names. */
  options?: Record<string, string|number|boolean|(string | number)[]>;
}

export interface Verifier {
  /**
   * Checks a program. Returns the certificate as JSON; for a question or a program that cannot be understood
   * {"error": "place: fault, and remedy"}.
   */
  check(program: string, question: string|Question): string;
  /** Names that `options` of a question may have. */
  optionNames(): string[];
}

export function createVerifier(settings?: {wasmBinary?: Uint8Array|ArrayBuffer}): Promise<Verifier>;
