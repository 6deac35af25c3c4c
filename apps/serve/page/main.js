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

/** Files dropped anywhere are for the tab that is shown; they must not replace the page. */
function takeDropped() {
  const shade = (/** @type {boolean} */ isOver) => {
    document.body.classList.toggle('dropping', isOver);
  };
  document.addEventListener('dragover', event => {
    event.preventDefault();
    shade(event.dataTransfer?.types.includes('Files') ?? false);
  });
  document.addEventListener('dragleave', event => {
    if (!event.relatedTarget) shade(false);
  });
  document.addEventListener('drop', event => {
    const isTaken = event.defaultPrevented, files = event.dataTransfer?.files;
    event.preventDefault();
    shade(false);
    const shown = tabs.find(name => !element(name).hidden);
    if (!isTaken && files && files.length > 0 && shown) ({plan, check, elements, tour})[shown].files.add(files);
  });
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
  takeDropped();
}

/** @type {FieldPlace[]} */
const fieldPlaces = ['drawing', 'stock', 'holding', 'tools', 'machine', 'cutting', 'research'];

/** Research is shown where somebody asks for it. @type {(isShown: boolean) => void} */
function showResearch(isShown) {
  element('research-go').setAttribute('aria-pressed', String(isShown));
  research.isShown = isShown;
  for (const fields of shownFields) fields.show(['--strategy']);
  showOperations();
  for (const tab of /** @type {const} */ (['elements', 'tour'])) {
    element(`tab-${tab}`).hidden = !isShown || !commands.has(tab);
    if (!isShown && !element(tab).hidden) showTab('plan');
  }
  element('research-box').hidden = !isShown;
}
/** Those that this page has. @type {Set<string>} */
const commands = new Set();

async function setUpOptions() {
  const options = await pipeline.options();
  learnJobKeys(options);
  // A page without a server may have fewer commands.
  for (const name of Object.keys(options)) commands.add(name);
  for (const option of options.info ?? []) readNames.add(nameOfOption(option));
  readNames.delete('--origin');  // places stay those of the drawing, wherever the zero is
  setUpPlanFields(options.plan ?? []);
  /** @type {(command: string, name: string) => string[]} */
  const values = (command, name) => options[command]?.find(one => one.names.includes(name))?.values ?? [];
  fillSelect(element('dialect'), values('verify', '--dialect'), 'recognise it');
  fillSelect(element('elements-post'), values('elements', '--post').filter(name => name !== 'linuxcnc'), 'linuxcnc');
  fillSelect(element('tour-objective'), values('tour', '--objective'));
  fillSelect(element('tour-solver'), values('tour', '--solver'));
  showTourCommand();
  const without = (/** @type {string} */ command, /** @type {string[]} */ names) => (
    options[command] ?? []).filter(one => !one.positional && !['Output', 'Help'].includes(one.group) && !names.includes(nameOfOption(one)));
  check.answers = fieldsWithin(
    'check-option-', without('verify', ['--part', '--depth', '--stock', '--dialect']), element('fields-check'), showCheckCommand);
  elements.answers = fieldsWithin('elements-option-',
    without('elements',
      ['--line', '--arc', '--pocket', '--hole', '--slot', '--tool', '--stock', '--resolution', '--solver', '--generations', '--post']),
    element('fields-elements'), showElementsCommand);
  tour.answers = fieldsWithin('tour-option-', without('tour', ['--objective', '--solver', '--time', '--seed', '--closed', '--open']),
    element('fields-tour'), showTourCommand);
  await goOn();
}

fillSelect(element('check-kind'), toolKinds.slice(0, 7));
element('research-go').addEventListener('click', () => showResearch(element('research-go').getAttribute('aria-pressed') !== 'true'));
showResearch(false);
for (const word of document.querySelectorAll('[data-solids]')) word.toggleAttribute('hidden', pipeline.noSolids !== '');
for (const place of document.querySelectorAll('[data-no-solids]')) {
  place.textContent = ` ${pipeline.noSolids}`;
  place.toggleAttribute('hidden', pipeline.noSolids === '');
}
if (pipeline.promise) element('promise').textContent = pipeline.promise;
element('lengths').addEventListener('change', chooseLengths);
watchTyping(() => {
  showTools();
  showOperations();
  showSaidOutlines();
});
setUpTabs();
setUpPlan();
setUpDrawing();
setUpMenu();
setUpPlaces();
setUpTools();
setUpOperations();
setUpReadings();
setUpBeside();
setUpCheck();
setUpElements();
setUpTour();
setUpOptions().catch(error => say(element('plan-status'), error.message, true));
