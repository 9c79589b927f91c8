// What the user looks at: a moment, a window of time, a row; and when to draw it again.
const look = {now: 0, from: 0, to: end, selected: null, incident: -1, hover: null, playing: false};
const painters = {};
const dirty = new Set();
let frame = 0;

function repaint(...names) {
  names.forEach((name) => dirty.add(name));
  if (!frame) frame = requestAnimationFrame(paint);
}
function paint() {
  frame = 0;
  const names = [...dirty];
  dirty.clear();
  for (const name of ['overview', 'axis', 'rows', 'cursor', 'arena', 'moment']) if (names.includes(name)) painters[name]();
}

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const shortest = Math.min(200, end);

function showWindow(from, to) {
  const length = clamp(to - from, shortest, end);
  const begin = clamp(from, 0, end - length);
  look.from = begin;
  look.to = begin + length;
  repaint('overview', 'axis', 'rows', 'cursor');
}
function zoom(factor, around) {
  const length = clamp((look.to - look.from) * factor, shortest, end);
  const share = (around - look.from) / (look.to - look.from);
  showWindow(around - length * share, around + length * (1 - share));
}
function pan(share) {
  const step = (look.to - look.from) * share;
  showWindow(look.from + step, look.to + step);
}
function choose(time, keepWindow) {
  look.now = clamp(Math.round(time), 0, end);
  const length = look.to - look.from;
  if (!keepWindow && (look.now < look.from || look.now > look.to)) showWindow(look.now - length / 2, look.now + length / 2);
  repaint('overview', 'axis', 'cursor', 'arena', 'moment');
}
function select(row) {
  look.selected = row;
  repaint('rows', 'cursor', 'arena', 'moment');
}

// Geometry of whatever has a time axis: names in the gutter, then the plot.
const geometry = {width: 800, gutter: 120};
const plotWidth = () => geometry.width - geometry.gutter - 20;
const xOf = (time) => geometry.gutter + (time - look.from) / (look.to - look.from) * plotWidth();
const timeAt = (x) => look.from + (x - geometry.gutter) / plotWidth() * (look.to - look.from);

const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400];
function ticks() {
  const span = (look.to - look.from) / 1000, most = Math.max(2, plotWidth() / 80);
  const step = steps.find((each) => span / each <= most) || Math.pow(10, Math.ceil(Math.log10(span / most)));
  const found = [];
  for (let k = Math.ceil(look.from / 1000 / step - 1e-9); k * step * 1000 <= look.to + 1e-6; k++) {
    const at = k * step;
    let text = String(Number(at.toFixed(1)));
    if (end >= 900000) {
      const whole = Math.floor(at), two = (number) => String(number).padStart(2, '0');
      text = `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
      if (step < 1) text += (at % 1).toFixed(1).slice(1);
    }
    found.push([at * 1000, text]);
  }
  return found;
}

const measure = document.createElement('canvas').getContext('2d');
const widths = new Map();
function textWidth(text, font) {
  const key = font + text;
  let width = widths.get(key);
  if (width === undefined) {
    if (widths.size > 5000) widths.clear();
    measure.font = `${font} system-ui, sans-serif`;
    width = measure.measureText(text).width;
    widths.set(key, width);
  }
  return width;
}
// As much of a text as there is room for; nothing where that would say nothing.
function fitted(text, font, room) {
  if (textWidth(text, font) <= room) return text;
  // Names that begin alike differ at their ends, so both stay.
  const cut = (length) => text.slice(0, Math.ceil(length / 2)) + '…' + text.slice(text.length - Math.floor(length / 2));
  let length = Math.floor(text.length * room / textWidth(text, font));
  while (length > 2 && textWidth(cut(length), font) > room) length--;
  return length > 2 ? cut(length) : '';
}

// A word beside the pointer.
const tip = make('div', {class: 'tip', role: 'presentation'});
document.body.append(tip);
function showTip(event, lines) {
  if (!lines || !lines.length) return hideTip();
  tip.replaceChildren(...lines.map((line, at) => make(at ? 'div' : 'b', {}, ...(Array.isArray(line) ? line : [line]))));
  tip.classList.add('shown');
  const box = tip.getBoundingClientRect();
  tip.style.left = `${clamp(event.clientX + 14, 4, innerWidth - box.width - 4)}px`;
  tip.style.top = `${event.clientY + 18 + box.height > innerHeight ? event.clientY - box.height - 10 : event.clientY + 18}px`;
}
function hideTip() { tip.classList.remove('shown'); }
