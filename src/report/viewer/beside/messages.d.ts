// What a page tells the reports that it shows side by side, and what they tell it, as messages between windows.

/** What of the part is seen. */
interface Look {
  /** In space, or flat from above. */
  space: boolean;
  /** The place in the middle, mm; pixels per mm; degrees around z and above the horizon. */
  camera: [number, number, number, number, number, number];
  /** Of the flat picture: the middle, mm; pixels per mm. */
  flat: [number, number, number];
  /** '', 'x', 'y' or 'z', and where its slider stands. */
  section: string;
  sectionAt: number;
}

/** From a report. `ready`: it can be told; its time is so many s. `look`, `time`: somebody has changed it there. `shown`: the time that it was told is seen. */
type ReportMessage = { clearcut: 'ready'; total: number } | { clearcut: 'look'; look: Look } | { clearcut: 'time'; time: number } | { clearcut: 'shown' };
/** To a report. `ask`: for its look; `time`: s, to be shown. */
type ReportOrder = { clearcut: 'ask' } | { clearcut: 'look'; look: Look } | { clearcut: 'time'; time: number };
