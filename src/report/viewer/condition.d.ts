// What reports and certificates share (certificate_json.cpp).

/** What the verdict rests on, as a certificate has it, too. */
interface Condition {
  name: string;
  text: string;
  /** Of the program; 0: of no line. */
  line: number;
  /** What meets it; '': nothing does yet. */
  met_by: string;
}
