// Wires the parts: sizes, keys, buttons, links to moments, playing, printing, theme.
const said = byId('said');

function goToIncident(number) {
  const incident = incidents[number];
  if (!incident) return;
  look.incident = number;
  const who = incident.robots.length ? robots[incident.robots[0]] : null;
  if (who) select({kind: 'robot', name: who.id});
  choose(incident.from);
  repaint('rows', 'cursor');
  said.textContent = `${seconds(incident.from)}: ${incident.text}`;
}
function nextIncident(step) {
  const order = incidents.map((each, number) => [each.from, number]);
  const found = step > 0 ? order.find(([time]) => time > look.now + 0.5) : order.reverse().find(([time]) => time < look.now - 0.5);
  if (found) goToIncident(found[1]);
}
function nextEvent(step) {
  const at = step > 0 ? lastUntil(eventTimes, look.now) + 1 : lastUntil(eventTimes, look.now - 1);
  if (at < 0 || at >= events.length) return;
  choose(eventTimes[at]);
  said.textContent = events[at][2];
}
function nextRow(step) {
  const rows = shown.rows.filter((row) => row.kind === 'robot' || row.kind === 'task');
  if (!rows.length) return;
  const now = look.selected ? rows.findIndex((row) => row.kind === look.selected.kind && row.name === look.selected.name) : -1;
  const row = rows[clamp(now < 0 ? (step > 0 ? 0 : rows.length - 1) : now + step, 0, rows.length - 1)];
  select({kind: row.kind, name: row.name});
  if (rowsBox.classList.contains('tall')) rowsBox.scrollTop = clamp(rowsBox.scrollTop, row.top + row.height - rowsBox.clientHeight + 30, Math.max(row.top - 30, 0));
  said.textContent = wordsFor(row, look.now, 500).filter((line) => typeof line === 'string').join('. ');
}

// Playing: so many seconds of the mission a second of the wall clock.
let playedAt = 0;
function play(on) {
  look.playing = on && look.now < end;
  byId('play').textContent = look.playing ? '❚❚' : '▶';
  byId('play').setAttribute('aria-label', look.playing ? 'Stop (Space)' : 'Play (Space)');
  playedAt = 0;
  if (look.playing) requestAnimationFrame(tick);
}
function tick(at) {
  if (!look.playing) return;
  if (playedAt) choose(look.now + (at - playedAt) * Number(byId('speed').value));
  playedAt = at;
  if (look.now >= end) play(false); else requestAnimationFrame(tick);
}
const playOrStop = () => { if (!look.playing && look.now >= end) choose(0); play(!look.playing); };

const middle = () => look.now >= look.from && look.now <= look.to ? look.now : (look.from + look.to) / 2;
const keys = {
  ArrowLeft: (event) => choose(look.now - (event.shiftKey ? 10000 : 1000)),
  ArrowRight: (event) => choose(look.now + (event.shiftKey ? 10000 : 1000)),
  ArrowUp: () => nextRow(-1), ArrowDown: () => nextRow(1),
  Home: () => choose(0), End: () => choose(end),
  n: () => nextIncident(1), p: () => nextIncident(-1), e: () => nextEvent(1), b: () => nextEvent(-1),
  '+': () => zoom(0.5, middle()), '=': () => zoom(0.5, middle()), '-': () => zoom(2, middle()),
  '[': () => pan(-0.25), ']': () => pan(0.25), 0: () => showWindow(0, end),
  ' ': playOrStop, Escape: () => { play(false); select(null); look.incident = -1; },
};
byId('explorer').addEventListener('keydown', (event) => {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const onControl = event.target.closest('button, select, input, a, summary');
  if (event.ctrlKey || event.metaKey || event.altKey || !(key in keys)) return;
  if (onControl && (key === ' ' || (onControl.tagName === 'SELECT' && key.startsWith('Arrow')))) return;
  event.preventDefault();
  keys[key](event);
});

const press = {
  play: playOrStop, back: () => nextEvent(-1), on: () => nextEvent(1), fit: () => showWindow(0, end),
  'zoom-in': () => zoom(0.5, middle()), 'zoom-out': () => zoom(2, middle()),
  next: () => nextIncident(1), previous: () => nextIncident(-1),
};
for (const [id, action] of Object.entries(press)) byId(id).addEventListener('click', action);
if (!incidents.length) for (const id of ['next', 'previous']) byId(id).disabled = true;

// Which parts the timeline shows.
const members = {robots, tasks};
panels.forEach((panel, at) => { members[`panel${at}`] = panel.groups; });
for (const key of Object.keys(parts)) {
  if (!members[key].length) continue;
  const box = make('input', {type: 'checkbox', checked: ''});
  box.addEventListener('change', () => { parts[key] = box.checked; layOut(); repaint('rows', 'cursor'); });
  byId('parts').append(make('label', {}, box, partTitles[key]));
}

// Links to moments: #t=73.700, and &incident=2 for one of the list.
function follow(hash) {
  const found = /^#t=(-?[0-9.]+)(?:&incident=([0-9]+))?$/.exec(hash);
  if (!found) return false;
  play(false);
  if (found[2] !== undefined) goToIncident(Number(found[2]));
  else choose(Number(found[1]) * 1000);
  return true;
}
document.addEventListener('click', (event) => {
  const link = event.target.closest('a.when');
  if (!link || event.button !== 0 || event.ctrlKey || event.metaKey || !follow(link.hash)) return;
  event.preventDefault();
  try { history.replaceState(null, '', link.hash); } catch (error) { /* some browsers let no file do that */ }
  if (!byId('mission').contains(link)) byId('mission').scrollIntoView({block: 'start'});
  axisBox.focus({preventScroll: true});
});
addEventListener('hashchange', () => { if (follow(location.hash)) byId('mission').scrollIntoView({block: 'start'}); });

function resize() {
  const width = Math.floor(rowsBox.clientWidth) || 700;
  geometry.width = width;
  geometry.gutter = clamp(Math.ceil(Math.max(60, ...[...robots, ...tasks].slice(0, 400).map((each) => textWidth(each.id, '600 12px') + 28))), 84, Math.min(190, width * 0.3));
  arenaWidth = Math.floor(arenaBox.clientWidth) || 480;
  repaint('overview', 'axis', 'rows', 'cursor', 'arena', 'moment');
}

// On paper: the whole mission, all rows, drawn for the width of the paper before it goes out.
let before = null;
function toPaper() {
  if (before) return;
  before = {from: look.from, to: look.to};
  shown.all = true;
  showWindow(0, end);
  resize();
  paint();
}
function fromPaper() {
  if (!before) return;
  shown.all = false;
  showWindow(before.from, before.to);
  before = null;
  resize();
}
addEventListener('beforeprint', toPaper);
addEventListener('afterprint', fromPaper);
matchMedia('print').addEventListener('change', (event) => { if (event.matches) toPaper(); else fromPaper(); });

// Light, dark, or as the system has it; kept where the browser lets a file keep anything.
const themes = ['system', 'light', 'dark'];
function dress(theme) {
  if (theme === 'system') delete document.documentElement.dataset.theme; else document.documentElement.dataset.theme = theme;
  byId('theme').textContent = {system: '◐ Theme', light: '☀ Light', dark: '☾ Dark'}[theme];
  try { localStorage.setItem('rqt_mrta_py-theme', theme); } catch (error) { /* then it is forgotten */ }
}
let theme = 'system';
try { theme = localStorage.getItem('rqt_mrta_py-theme') || theme; } catch (error) { /* as the system has it */ }
if (!themes.includes(theme)) theme = 'system';
dress(theme);
byId('theme').addEventListener('click', () => {
  theme = themes[(themes.indexOf(theme) + 1) % themes.length];
  dress(theme);
});

if (!hasPlaces) document.documentElement.classList.add('no-places');
axisBox.setAttribute('tabindex', '0');
axisBox.setAttribute('role', 'slider');
axisBox.setAttribute('aria-label', 'Moment of the mission');
axisBox.setAttribute('aria-valuemin', '0');
axisBox.setAttribute('aria-valuemax', (end / 1000).toFixed(1));
layOut();
resize();
if (!follow(location.hash)) choose(incidents.length ? incidents[0].from : end);
paint();
new ResizeObserver(() => { if (!before && (Math.floor(rowsBox.clientWidth) !== geometry.width || (arenaBox.clientWidth && Math.floor(arenaBox.clientWidth) !== arenaWidth))) resize(); }).observe(byId('explorer'));
document.documentElement.classList.add('ready');
