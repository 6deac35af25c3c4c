// Tabs, and what the command itself says of its options.

/** @type {TabName[]} */
const tabs = ['plan', 'check', 'elements', 'tour'];

/** @type {(name: TabName) => void} */
function showTab(name) {
  for (const one of tabs) {
    const chosen = one === name;
    element(one).hidden = !chosen;
    element(`tab-${one}`).setAttribute('aria-selected', String(chosen));
    element(`tab-${one}`).tabIndex = chosen ? 0 : -1;
  }
}

/** @type {() => void} */
function setUpTabs() {
  tabs.forEach(name => {
    const tab = element(`tab-${name}`);
    tab.addEventListener('click', () => showTab(name));
    tab.addEventListener('keydown', event => {
      if (event.key !== 'ArrowRight' && event.key !== 'ArrowLeft') return;
      const shown = tabs.filter(one => !element(`tab-${one}`).hidden), step = event.key === 'ArrowRight' ? 1 : shown.length - 1;
      const next = shown[(shown.indexOf(name) + step) % shown.length];
      showTab(next);
      element(`tab-${next}`).focus();
    });
  });
  // A file dropped beside a list must not replace the page.
  document.addEventListener('dragover', event => event.preventDefault());
  document.addEventListener('drop', event => event.preventDefault());
}

const toolKinds = ['endmill', 'facemill', 'bullnose', 'ball', 'drill', 'reamer'];  // others need an angle: see the options

async function setUpOptions() {
  const options = await pipeline.options();
  learnJobKeys(options);
  // A page without a server may have fewer commands.
  element('tab-elements').hidden = !options.elements;
  element('tab-tour').hidden = !options.tour;
  /** @type {(command: string, name: string) => string[]} */
  const values = (command, name) => options[command]?.find(one => one.names.includes(name))?.values ?? [];
  fillSelect(element('unit'), values('plan', '--unit'), 'as the file says');
  fillSelect(element('strategy'), values('plan', '--strategy').filter(name => name !== 'auto'), 'the fastest');
  fillSelect(element('material'), values('plan', '--material'), 'not said');
  fillSelect(element('post'), values('plan', '--post').filter(name => name !== 'linuxcnc'), 'linuxcnc');
  fillSelect(element('dialect'), values('verify', '--dialect'), 'recognise it');
  fillSelect(element('elements-post'), values('elements', '--post').filter(name => name !== 'linuxcnc'), 'linuxcnc');
  fillSelect(element('tour-objective'), values('tour', '--objective'));
  fillSelect(element('tour-solver'), values('tour', '--solver'));
  showTourCommand();
  /** @type {['plan-names' | 'check-names' | 'elements-names' | 'tour-names', string][]} */
  const lists = [['plan-names', 'plan'], ['check-names', 'verify'], ['elements-names', 'elements'], ['tour-names', 'tour']];
  for (const [list, command] of lists) {
    const usable = (options[command] ?? []).filter(one => !one.positional && !['Output', 'Help'].includes(one.group));
    element(list).replaceChildren(
      ...usable.map(one => made('option', '', {value: `${one.names.at(-1)}${one.value ? ' ' : ''}`, label: one.help.slice(0, 80)})));
  }
}

for (const select of [element('tool-kind'), element('check-kind')]) fillSelect(select, toolKinds);
for (const word of document.querySelectorAll('[data-solids]')) word.toggleAttribute('hidden', pipeline.noSolids !== '');
for (const place of document.querySelectorAll('[data-no-solids]')) {
  place.textContent = ` ${pipeline.noSolids}`;
  place.toggleAttribute('hidden', pipeline.noSolids === '');
}
if (pipeline.promise) element('promise').textContent = pipeline.promise;
element('lengths').addEventListener('change', chooseLengths);
setUpTabs();
setUpPlan();
setUpDrawing();
setUpReadings();
setUpBeside();
setUpCheck();
setUpElements();
setUpTour();
setUpOptions().catch(error => say(element('plan-status'), error.message, true));
