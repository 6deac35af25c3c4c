// The examples as a person would plan them, for the tests of the page's homes and of Clearcut for Windows.

/**
 * A file of examples/, what has to be said of it, what is said to `plan` alone, and the files that it names. `setups`: a job of several
 * set-ups, and what `verify` is told of each.
 * @typedef {{ part: string, options: string, planOnly?: string, others?: string[], setups?: string[] }} Example
 */

/** @type {Example[]} */
export const EXAMPLES = [
  {part: 'bracket.dxf', options: '--tool endmill:6 --stepdown 2.5'},
  {part: 'bracket.svg', options: '--tool endmill:6'},
  {part: 'bracket.json', options: '--tool endmill:6'},
  {part: 'bracket.step', options: '--tool endmill:6'},
  {part: 'bracket.toml', options: '', others: ['bracket.dxf', 'mill.toml', 'tools.toml']},
  {part: 'fishhead.p21', options: '--stepdown 50'},
  {part: 'fishhead_sloped.p21', options: '--stepdown 50'},
  {part: 'strategies.p21', options: ''},
  {part: 'sign.dxf', options: '--tool vbit:60deg:10'},
  {part: 'plate.dxf', options: '--tool endmill:5 --tool chamfer:90deg:8:tip=0.4 --stepdown 3'},
  {part: 'inch_plate.dxf', options: '--tool endmill:0.25in --tool drill:0.201in --tabs 4'},
  {part: 'inlay_hole.dxf', options: '--tool vbit:60deg:10 --tool endmill:3 --stepdown 4'},
  {part: 'inlay_plug.dxf', options: '--tool vbit:60deg:10 --tool endmill:3 --stepdown 4'},
  {part: 'flange.toml', options: '', others: ['flange.dxf']},
  {part: 'gland.toml', options: '', others: ['gland.dxf']},
  {part: 'nested.step', options: '--tool endmill:6 --stepdown 8'},
  {part: 'awkward.step', options: '--tool endmill:4 --stepdown 8'},
  {part: 'disc.step', options: '--tool endmill:6'},
  {part: 'sideways.step', options: '--up -X --tool endmill:3'},
  {part: 'on_edge.step', options: '--up +Y --tool endmill:6'},
  {part: 'plate_and_pins.step', options: '--body PLATE --tool endmill:4'},
  {part: 'two_sided.step', options: '--tool endmill:6'},
  {part: 'two_sided.toml', options: '', others: ['two_sided.step'], setups: ['--setup 1', '--setup 2 --earlier-setup EARLIER']},
  {part: 'board-Edge_Cuts.gbr', options: '--depth 1.6 --tool endmill:2 --tabs 4 --tab-height 0.5'},
  {part: 'board-F_Cu.gbr', options: '--depth 0.1 --tool endmill:0.2', planOnly: '--feed 300'},
  {part: 'board-PTH.drl', options: '--depth 1.6 --tool drill:0.8 --tool drill:1 --tool endmill:0.8'},
];

/** What every example may have and nobody is asked: corners out of reach of its cutters, tools changed by hand, parts that come loose, faces that no work from above makes. */
export const ACCEPTED = ['out-of-reach', 'tool-by-hand', 'loose-part', 'left-out'].map(name => `--accept ${name}`).join(' ');

/** As on the command line. @type {(example: Example) => string} */
export const optionsOf = example => [example.options, example.planOnly ?? '', ACCEPTED].filter(words => words).join(' ');
/** @type {(example: Example) => string[]} */
export const filesOf = example => [example.part, ...example.others ?? []];
export const stemOf = (/** @type {string} */ name) => name.replace(/\.[^.]*$/, '');
/** The names under which a page gives the programs away. @type {(example: Example) => string[]} */
export const programsOf = example =>
  (example.setups ?? ['']).map((_, k) => `${stemOf(example.part)}${example.setups ? `-${k + 1}` : ''}.ngc`);
