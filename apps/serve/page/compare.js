// All strategies that fit the part, planned and certified side by side.

/** What is no finite number comes as null. @type {(value: number | null, count: number) => string} */
const digits = (value, count) => value === null ? '?' : value.toFixed(count);
/** @type {[string, (one: PlannedRun) => string][]} */
const compareColumns = [
  ['strategy', one => one.fastest ? `${one.strategy}, the fastest` : one.strategy], ['clean', one => one.clean ? 'yes' : 'no'],
  ['time', one => minutes(one.time_s)], ['feed mm', one => digits(one.feed_mm, 0)], ['retracts', one => String(one.retracts)],
  ['engagement', one => `${digits(one.engagement_max_deg, 0)}°`], ['left mm', one => digits(one.uncut_thickness_mm, 4)]
];

/** @type {(seconds: number | null) => string} */
function minutes(seconds) {
  if (seconds === null) return '?';
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

/** @type {(one: StrategyRun, shownFirst: string[]) => HTMLElement} */
function compareRow(one, shownFirst) {
  const row = made('tr', '', one.planned && one.fastest ? {class: 'fastest'} : {});
  if (!one.planned) {
    row.append(made('td', one.strategy), made('td', one.refusal || 'does not fit', {colspan: String(compareColumns.length + 1)}));
    return row;
  }
  const take = made('button', 'Take', {type: 'button', 'aria-label': `Take the strategy ${one.strategy}`});
  take.addEventListener('click', () => {
    answer('--strategy', one.strategy === 'auto' ? null : [one.strategy]);
    say(element('plan-status'), `The next plan takes ${one.strategy}.`);
  });
  const last = made('td'), shown = made('td');
  last.append(take);
  shown.append(besideBox(one, shownFirst.includes(one.strategy)));
  row.append(...compareColumns.map(([, text]) => made('td', text(one))), shown, last);
  return row;
}

/** @type {(found: { strategies: StrategyRun[] }) => void} */
function showComparison(found) {
  const head = made('tr'), shownFirst = firstBeside(found.strategies);
  head.append(
    ...[...compareColumns.map(([title]) => title), 'show', ''].map(title => title ? made('th', title, {scope: 'col'}) : made('td')));
  theOne('thead', element('comparison')).replaceChildren(head);
  theOne('tbody', element('comparison')).replaceChildren(...found.strategies.map(one => compareRow(one, shownFirst)));
  limitBeside();
}

const comparing = new Run('compare', {
  ended: () => showPlanCommand(),
  async done(state) {
    element('compare-result').hidden = true;
    const found = await textAt(state.results.text);
    showComparison(JSON.parse(found));
    element('compare-result').hidden = false;
    element('compare-result').open = true;
    say(element('compare-status'), 'Compared.');
  },
});

/** Another part: what was compared is not shown any more. */
function forgetComparison() {
  comparing.cancel();
  element('show-compare').hidden = true;
  if (element('plan').dataset.middle === 'compare') showMiddle('drawing');
  say(element('compare-status'), '');
  element('compare-result').hidden = true;
  forgetBeside();
}

/** @type {() => Promise<void>} */
async function startComparison() {
  forgetBeside();
  const asked = await planAsked(planOptions({strategy: false}));
  if (!asked) return;
  compared = formOfPlan(asked);
  element('show-compare').hidden = false;
  showMiddle('compare');
  await comparing.start(compared);
}
