// A drawing that may be read in several ways: each of them drawn, and a click says which is meant.

/** What an answer says, by its option and the kind that it names; others say it themselves. @type {Record<string, string>} */
const readingWords = {
  'profile': 'The edge of the part: cut out along it',
  'pocket:outer': 'A pocket: what lies in it stays',
  'pocket': 'Milled with that pocket',
  'island': 'Stays standing in that pocket',
  'step': 'A step that stays in that pocket',
  'ignore': 'Left out',
  '--unit mm': 'Drawn in millimetres',
  '--unit inch': 'Drawn in inches',
  '--scale 1': 'The size is right'
};
/** @type {(answer: DrawingAnswer) => string} */
const wordsOfAnswer = ({option, value}) =>
  readingWords[`${option} ${value}`] ?? readingWords[value] ?? readingWords[value.split(':')[0]] ?? `${option} ${value}`;
/** @type {(answer: DrawingAnswer) => string} */
const optionOfAnswer = ({option, value}) => `${option} ${quoted(value)}`;

/** The question without the options of the command line that answer it. @type {(ask: string) => string} */
const plainQuestion = ask => ask.split(/: --op |; say which unit|: if it is meant/)[0].replace(/^./, letter => letter.toUpperCase());

/** What is made of the outlines in a reading: "1 profile, 5 pockets". @type {(outlines: OutlineInfo[]) => string} */
function rolesSaid(outlines) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const {role} of outlines)
    if (role) counts.set(role, (counts.get(role) ?? 0) + 1);
  return [...counts].map(([role, count]) => `${count} ${role}${count > 1 && /[a-df-z]$/.test(role) ? 's' : ''}`).join(', ');
}

/** @type {(outlines: OutlineInfo[]) => string} */
function sizeOfDrawing(outlines) {
  const extent = extentOfDrawing(outlines);
  return extent ? `${shownLength(extent.x[1] - extent.x[0], 2)} × ${shownLength(extent.y[1] - extent.y[0], 2)} ${lengthName()}` : '';
}

/** @type {(answer: DrawingAnswer, info: PartInfo) => HTMLElement} */
function readingButton(answer, info) {
  const button = made('button', '', {type: 'button'}), picture = madeSvg('svg', {'class': 'drawing', 'aria-hidden': 'true'}),
        curves = madeSvg('g', {transform: 'scale(1 -1)'});
  const outlines = info.outlines, extent = extentOfDrawing(outlines);
  if (extent) picture.setAttribute('viewBox', viewBoxOf(extent));
  curves.append(...curvesOf(outlines, one => one.role));
  picture.append(curves);
  button.append(
    picture, made('strong', wordsOfAnswer(answer)), made('span', answer.option === '--op' ? rolesSaid(outlines) : sizeOfDrawing(outlines)));
  button.addEventListener('click', () => giveAnswer(answer));
  return button;
}

/** @type {(answer: DrawingAnswer) => void} */
function giveAnswer(answer) {
  if (answer.option === '--op') change('', {given: [...project.now.given, answer]});
  else change('', {answers: {...project.now.answers, [answer.option]: [answer.value]}});
  element('outlines-title').focus();
}

/** What was answered so far, and the way to ask again. */
function showGiven() {
  element('given').hidden = project.now.given.length === 0;
  element('given-words').textContent = project.now.given.map(wordsOfAnswer).join('; ');
}

/** Reads the drawing by each answer, and offers what comes of it. @type {(info: PartInfo | null | undefined) => Promise<void>} */
async function offerReadings(info) {
  const mine = part.asked, answers = info?.answers ?? [];
  showGiven();
  if (!info || answers.length === 0) {
    element('readings').hidden = true;
    return;
  }
  const read = await Promise.all(answers.map(
    answer => pipeline
                .info(formOfPlan(
                  {input: fileOf(project.now, 'part')?.name ?? '', options: `${readOptions()} ${optionOfAnswer(answer)}`, files: []}))
                .catch(() => null)));
  if (mine !== part.asked) return;
  element('readings-question').textContent = `${shownText(plainQuestion(info.asks[0]))}. Which is meant?`;
  element('readings-list').replaceChildren(...answers.flatMap((answer, k) => {
    const found = read[k]?.info;
    return found && !('setups' in found) ? [readingButton(answer, found)] : [];
  }));
  element('readings').hidden = false;
}

function setUpReadings() { element('given-again').addEventListener('click', () => change('', {given: []})); }
