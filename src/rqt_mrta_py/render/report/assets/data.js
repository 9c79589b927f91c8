// The mission as the page carries it, unpacked. Times are milliseconds since its start.
const data = JSON.parse(document.getElementById('mission-data').textContent);
const end = Math.max(data.end, 1);

// Columns of whole numbers: differences, sign in the lowest bit, seven bits a byte, base 64.
function unpack(text, columns) {
  const bytes = atob(text);
  let at = 0;
  const next = () => {
    let number = 0, factor = 1, byte;
    do {
      byte = bytes.charCodeAt(at++);
      number += (byte & 127) * factor;
      factor *= 128;
    } while (byte > 127);
    return number;
  };
  const rows = next(), found = [];
  for (let column = 0; column < columns; column++) {
    const values = new Float64Array(rows);
    let before = 0;
    for (let row = 0; row < rows; row++) {
      const code = next();
      before += code % 2 ? -(code + 1) / 2 : code / 2;
      values[row] = before;
    }
    found.push(values);
  }
  return found;
}

// The place of the last time that is not after one; -1 if there is none.
function lastUntil(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
}

const robots = data.robots.map((robot, number) => {
  const [times, states] = unpack(robot.states, 2);
  return {...robot, number, times, states, held: [], track: robot.track && unpack(robot.track, 4)};
});
const tasks = data.tasks.map((task, number) => {
  const [times, states] = unpack(task.history, 2);
  return {...task, number, times, states, held: []};
});
const allocations = (([from, to, robot, task, outcome]) => Array.from(from, (_, at) => ({
  from: from[at], to: to[at], robot: robot[at], task: task[at], outcome: data.names.outcomes[outcome[at]],
})))(unpack(data.allocations, 5));
for (const each of allocations) {
  robots[each.robot].held.push(each);
  tasks[each.task].held.push(each);
}
const goneBody = 2;
const bodies = data.bodies.map((body) => ({...body, places: unpack(body.places, 6)}));
const panels = data.panels.map((panel) => ({
  ...panel,
  groups: panel.groups.map((group) => ({
    ...group, curves: group.curves.map((curve) => ({...curve, points: unpack(curve.points, 2)})),
  })),
}));
const incidents = data.incidents, labels = data.labels, events = data.events;
const eventTimes = events.map((event) => event[0]);
const hasPlaces = robots.some((robot) => robot.track) || tasks.some((task) => task.place) || data.arena;

const robotState = (robot, time) => {
  const at = lastUntil(robot.times, time);
  return at < 0 ? 'offline' : data.names.robots[robot.states[at]];
};
const taskState = (task, time) => {
  const at = lastUntil(task.times, time);
  return at < 0 ? '' : data.names.tasks[task.states[at]];
};
// What is held at a moment, what was begun last standing last.
const heldAt = (held, time) => held.filter((each) => each.from <= time && (time < each.to || (each.outcome === 'open' && time <= each.to)));

function poseAt(robot, time) {
  if (!robot.track || (robot.gone !== null && time >= robot.gone)) return null;
  const [times, xs, ys, turns] = robot.track;
  const at = lastUntil(times, time);
  if (at < 0) return null;
  const share = at + 1 < times.length ? (time - times[at]) / Math.max(times[at + 1] - times[at], 1) : 0;
  const next = Math.min(at + 1, times.length - 1);
  const between = (values) => values[at] + (values[next] - values[at]) * share;
  return {x: between(xs) * data.resolution, y: between(ys) * data.resolution, yaw: between(turns) * Math.PI / 128};
}

// Times as people read them: 62.0 s, from a quarter of an hour on 1:02:05 h.
function seconds(time) {
  const sign = time < 0 ? '-' : '', passed = Math.abs(time) / 1000;
  if (passed < 899.95) return `${sign}${passed.toFixed(1)} s`;
  const whole = Math.round(passed), two = (number) => String(number).padStart(2, '0');
  return `${sign}${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)} h`;
}

// Text goes into the page as text only.
function make(tag, attributes, ...content) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) if (value !== null) made.setAttribute(name, value);
  made.append(...content.filter((each) => each !== null));
  return made;
}
function draw(tag, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const name in attributes) made.setAttribute(name, attributes[name]);
  if (text !== undefined) made.textContent = text;
  return made;
}
const byId = (id) => document.getElementById(id);
