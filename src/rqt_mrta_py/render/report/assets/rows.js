// The timeline: a row for incidents, one for each robot and task, one for each chart of curves.
const rowsBox = byId('rows');
const parts = {robots: true, tasks: true};
panels.forEach((_, at) => { parts[`panel${at}`] = true; });
const partTitles = {robots: 'Robots', tasks: 'Tasks'};
panels.forEach((panel, at) => { partTitles[`panel${at}`] = panel.title; });
const laneHeight = 18, shown = {rows: [], height: 0, all: false};
const painted = {};

// Bars of one row that overlap stand in lanes of their own.
function lanesOf(held) {
  const free = [];
  for (const each of held) {
    let lane = free.findIndex((until) => until <= each.from);
    if (lane < 0) lane = free.length < 6 ? free.push(0) - 1 : 5;
    free[lane] = each.to;
    each.lane = lane;
  }
  return Math.max(free.length, 1);
}
robots.forEach((robot) => { robot.lanes = lanesOf(robot.held); });

function layOut() {
  const rows = [];
  let top = 2;
  const add = (row, height) => { rows.push({...row, top, height}); top += height; };
  add({kind: 'incidents', name: 'incidents'}, 24);
  if (labels.some((label) => label[2] < 0 && label[3] < 0)) add({kind: 'scenario', name: 'scenario'}, 22);
  const part = (key, members, height) => {
    if (!members.length || !parts[key]) return;
    add({kind: 'head', key, name: `${partTitles[key]}`}, 26);
    for (const member of members) add(member, height(member));
  };
  part('robots', robots.map((robot) => ({kind: 'robot', name: robot.id, robot})), ({robot}) => robot.lanes * laneHeight + 14);
  part('tasks', tasks.map((task) => ({kind: 'task', name: task.id, task})), () => 21);
  panels.forEach((panel, at) => part(
    `panel${at}`, panel.groups.map((group) => ({kind: 'curves', name: group.id, panel, group})), () => 78));
  shown.rows = rows;
  shown.height = top + 2;
}

// With more rows than a few screens hold, the rows scroll in a box of their own, and only those in sight are drawn.
function rowsInSight() {
  const tall = shown.height > 3000 && !shown.all;
  rowsBox.classList.toggle('tall', tall);
  if (!tall) return shown.rows.filter((row) => row.top < 6000);
  const from = rowsBox.scrollTop - 100, to = rowsBox.scrollTop + Math.max(rowsBox.clientHeight, innerHeight) + 100;
  return shown.rows.filter((row) => row.top + row.height > from && row.top < to);
}

painters.rows = () => {
  const inSight = rowsInSight(), height = shown.all ? Math.min(shown.height, 6000) : shown.height;
  const svg = draw('svg', {viewBox: `0 0 ${geometry.width} ${height}`, width: geometry.width, height, role: 'img', 'aria-label': 'Timeline: rows of robots and tasks; the tables below tell the same'});
  const defs = draw('defs', {});
  const clip = draw('clipPath', {id: 'plot'});
  clip.append(draw('rect', {x: geometry.gutter, y: 0, width: plotWidth() + 1, height}));
  defs.append(clip);
  svg.append(defs);
  const grid = draw('g', {class: 'grid'});
  for (const [time] of ticks()) grid.append(draw('line', {x1: xOf(time), x2: xOf(time), y1: 0, y2: height}));
  const names = draw('g', {}), plot = draw('g', {'clip-path': 'url(#plot)'});
  for (const row of inSight) {
    if (row.kind !== 'head') {
      const chosen = look.selected && look.selected.kind === row.kind && look.selected.name === row.name;
      names.append(draw('rect', {x: 0, y: row.top, width: geometry.width, height: row.height, class: chosen ? 'row chosen' : 'row'}));
      names.append(draw('line', {x1: 0, x2: geometry.width, y1: row.top + row.height, y2: row.top + row.height, class: 'rule'}));
    }
    rowPainters[row.kind](row, names, plot);
  }
  painted.names = draw('g', {});
  painted.cursor = draw('g', {});
  painted.hover = draw('line', {class: 'hover', y1: 0, y2: height, x1: -9, x2: -9});
  svg.append(names, grid, plot, painted.names, painted.hover, painted.cursor);
  painted.height = height;
  painted.inSight = inSight;
  rowsBox.replaceChildren(svg);
};

// What changes with the chosen moment alone: the line, the robots' lights, dots on curves.
painters.cursor = () => {
  const lights = [], dots = [];
  for (const row of painted.inSight) {
    const y = row.top + row.height / 2;
    if (row.kind === 'robot') lights.push(light(8, y, 5, robotState(row.robot, look.now)));
    if (row.kind === 'curves' && look.now >= look.from && look.now <= look.to) dots.push(...curveDots(row, look.now));
  }
  painted.names.replaceChildren(...lights);
  const x = xOf(look.now);
  const line = look.now >= look.from && look.now <= look.to ? [draw('line', {x1: x, x2: x, y1: 0, y2: painted.height, class: 'now'})] : [];
  painted.cursor.replaceChildren(...line, ...dots);
};

// Idle a ring, busy a disc, offline a crossed disc.
function light(x, y, radius, state) {
  const group = draw('g', {class: `light ${state}`});
  group.append(draw('circle', {cx: x, cy: y, r: radius}));
  if (state === 'idle') group.append(draw('circle', {cx: x, cy: y, r: radius * 0.42, class: 'hole'}));
  const arm = radius * 0.45;
  if (state === 'offline') group.append(draw('path', {d: `M${x - arm},${y - arm}L${x + arm},${y + arm}M${x - arm},${y + arm}L${x + arm},${y - arm}`, class: 'cross'}));
  return group;
}

function name(row, names, left) {
  names.append(draw('text', {x: left, y: row.top + row.height / 2 + 4, class: 'name'}, fitted(row.name, '600 12px', geometry.gutter - left - 6)));
}
// The part of an interval that is in the window [pixels]; null if it is out of sight.
function span(from, to) {
  if (to < look.from || from > look.to) return null;
  const left = Math.max(xOf(from), geometry.gutter - 4), right = Math.min(xOf(to), geometry.width - 20);
  return {left, width: Math.max(right - left, 1)};
}
function mark(plot, row, time, word) {
  if (time < look.from || time > look.to) return;
  const x = xOf(time);
  plot.append(draw('line', {x1: x, x2: x, y1: row.top + 1, y2: row.top + row.height - 1, class: 'scenario'}));
  plot.append(draw('path', {d: `M${x},${row.top + 1}l4,4l-4,4l-4,-4z`, class: 'scenario'}));
  if (plotWidth() / (look.to - look.from) * 1000 > 0.2) plot.append(draw('text', {x: x + 6, y: row.top + row.height - 2, class: 'scenario halo'}, word));
}

const rowPainters = {
  incidents(row, names, plot) {
    name(row, names, 0);
    const y = row.top + row.height / 2;
    if (!incidents.length) plot.append(draw('text', {x: geometry.gutter + 4, y: y + 4, class: 'gutter'}, 'none'));
    incidents.forEach((each, number) => {
      const kind = data.names.severities[each.severity], bar = span(each.from, each.to);
      if (!bar) return;
      plot.append(draw('rect', {x: bar.left, y: y + 4, width: bar.width, height: 3, class: kind}));
      const x = xOf(each.from), big = number === look.incident ? 9 : 7;
      if (each.from >= look.from) plot.append(draw('path', {d: `M${x},${y - big}l${big},${big * 1.7}h${-2 * big}z`, class: `${kind} sign${number === look.incident ? ' chosen' : ''}`}));
    });
  },
  scenario(row, names, plot) {
    name(row, names, 0);
    for (const [time, word, robot, task] of labels) if (robot < 0 && task < 0) mark(plot, row, time, word);
  },
  head(row, names) {
    names.append(draw('text', {x: 0, y: row.top + 18, class: 'part'}, row.name));
    if (!row.key.startsWith('panel')) return;
    const panel = panels[Number(row.key.slice(5))], labelled = new Map();
    for (const group of panel.groups) for (const curve of group.curves) labelled.set(curve.label, curve.colour);
    let x = Math.max(geometry.gutter, textWidth(row.name, '600 13px') + 14);
    for (const [label, colour] of labelled) {
      const text = fitted(label, '11px', 150), wide = textWidth(text, '11px') + 34;
      if (x + wide > geometry.width - 24) {
        names.append(draw('text', {x, y: row.top + 18, class: 'key'}, '…'));
        break;
      }
      names.append(draw('line', {x1: x, x2: x + 16, y1: row.top + 14, y2: row.top + 14, class: `curve t${colour}`}));
      names.append(draw('text', {x: x + 20, y: row.top + 18, class: 'key'}, text));
      x += wide;
    }
  },
  robot(row, names, plot) {
    name(row, names, 18);
    const {robot} = row, bottom = row.top + row.height - 8;
    let last = -9;
    robot.times.forEach((from, at) => {
      const bar = span(from, at + 1 < robot.times.length ? robot.times[at + 1] : end);
      if (!bar || bar.left + bar.width < last + 1) return;
      const state = data.names.robots[robot.states[at]], thick = {busy: 5, idle: 3, offline: 1.5}[state];
      plot.append(draw('rect', {x: bar.left, y: bottom + (5 - thick) / 2, width: bar.width, height: thick, class: `fill-${state}`}));
      last = bar.left + bar.width;
    });
    const ends = [];
    for (const each of robot.held) {
      const bar = span(each.from, each.to);
      if (!bar || (bar.width <= 1 && bar.left < (ends[each.lane] || -9) + 0.5)) continue;
      ends[each.lane] = bar.left + bar.width;
      const task = tasks[each.task], top = row.top + 4 + each.lane * laneHeight;
      plot.append(draw('rect', {x: bar.left, y: top, width: bar.width, height: laneHeight - 3, rx: 2, class: `bar t${task.colour} ${each.outcome}`}));
      const sign = data.names.signs[each.outcome], begin = Math.max(bar.left, geometry.gutter) + 5;
      const room = bar.left + bar.width - begin - 3 - (sign ? 12 : 0);
      const word = room > 14 ? fitted(task.id, '11px', room) : '';
      if (word) plot.append(draw('text', {x: begin, y: top + 11.5, class: `on t${task.colour}`}, word));
      if (sign && bar.width > 13 && each.to <= look.to) plot.append(draw('text', {x: bar.left + bar.width - 4, y: top + 11.5, class: `on end t${task.colour}`}, sign));
    }
    for (const [time, word, who] of labels) if (who === robot.number) mark(plot, row, time, word);
  },
  task(row, names, plot) {
    const {task} = row, middle = row.top + row.height / 2;
    names.append(draw('path', {d: `M8,${middle - 5}l5,5l-5,5l-5,-5z`, class: `diamond t${task.colour}`}));
    name(row, names, 18);
    let last = -9;
    task.times.forEach((from, at) => {
      const to = at + 1 < task.times.length ? task.times[at + 1] : end, bar = span(from, to);
      if (!bar || bar.left + bar.width < last + 1) return;
      last = bar.left + bar.width;
      const state = data.names.tasks[task.states[at]], busy = state === 'executing' || state === 'allocated';
      const thick = busy ? 14 : 4;
      plot.append(draw('rect', {x: bar.left, y: middle - thick / 2, width: bar.width, height: thick, rx: busy ? 2 : 0, class: `stage task-${state}`}));
      if (busy && bar.width > 24) {
        const held = task.held.filter((each) => each.from < to && each.to > from);
        held.forEach((each, place) => {
          const piece = span(Math.max(each.from, from), place + 1 < held.length ? held[place + 1].from : to);
          const word = piece ? fitted(robots[each.robot].id, '11px', piece.width - 8) : '';
          if (place && piece) plot.append(draw('line', {x1: piece.left, x2: piece.left, y1: middle - 7, y2: middle + 7, class: 'hand-over'}));
          if (word) plot.append(draw('text', {x: Math.max(piece.left, geometry.gutter) + 4, y: middle + 4, class: 'dark'}, word));
        });
      } else if (!busy && state !== 'waiting' && bar.width > 8) {
        plot.append(draw('text', {x: bar.left + 3, y: middle - 3, class: 'stage-sign'}, `${data.names.stages[state]} ${state}`));
      }
    });
    for (const [time, word, who, what] of labels) if (who < 0 && what === task.number) mark(plot, row, time, word);
  },
  curves: (row, names, plot) => paintCurves(row, names, plot),
};

function rowAt(event) {
  const y = event.clientY - rowsBox.firstChild.getBoundingClientRect().top;
  return shown.rows.find((row) => y >= row.top && y < row.top + row.height);
}
const lasting = (from, to) => `${seconds(from)} to ${seconds(to)} (${seconds(to - from)})`;
function wordsFor(row, time, near) {
  if (!row) return [seconds(time)];
  if (row.kind === 'incidents') {
    const close = incidents.filter((each) => Math.abs(each.from - time) < near || (each.from <= time && time <= each.to));
    return close.length ? close.slice(0, 4).map((each) => `${seconds(each.from)}  ${each.text}`) : [seconds(time)];
  }
  const lines = [`${row.name}, ${seconds(time)}`];
  if (row.kind === 'robot') {
    const at = lastUntil(row.robot.times, time);
    if (at >= 0) lines.push(`${robotState(row.robot, time)} since ${seconds(row.robot.times[at])}`);
    for (const each of heldAt(row.robot.held, time)) lines.push(`${tasks[each.task].id}: ${lasting(each.from, each.to)}, ${each.outcome.replace('_', ' ')}`);
  } else if (row.kind === 'task') {
    const at = lastUntil(row.task.times, time);
    if (at >= 0) lines.push(`${taskState(row.task, time)} since ${seconds(row.task.times[at])}`);
    for (const each of heldAt(row.task.held, time)) lines.push(`${robots[each.robot].id}: ${lasting(each.from, each.to)}, ${each.outcome.replace('_', ' ')}`);
  } else if (row.kind === 'curves') {
    for (const curve of row.group.curves) {
      const value = curveAt(curve, time);
      if (value !== null) lines.push([make('i', {class: `swatch t${curve.colour}`}), `${curve.label}: ${Number((value / row.panel.levels * row.panel.top).toPrecision(3))}`]);
    }
  }
  for (const label of labels) {
    const mine = row.kind === 'robot' ? label[2] === row.robot.number : row.kind === 'task' ? label[3] === row.task.number : row.kind === 'scenario';
    if (mine && Math.abs(label[0] - time) < near) lines.push(`${seconds(label[0])}  ${label[4] || label[1]}`);
  }
  return lines;
}

rowsBox.addEventListener('pointermove', (event) => {
  const x = localX(rowsBox, event);
  if (event.buttons) return hideTip();
  const inPlot = x >= geometry.gutter, time = clamp(timeAt(x), 0, end), row = rowAt(event);
  painted.hover.setAttribute('x1', inPlot ? x : -9);
  painted.hover.setAttribute('x2', inPlot ? x : -9);
  showTip(event, inPlot ? wordsFor(row, time, 6 * (look.to - look.from) / plotWidth()) : row && row.kind !== 'head' ? wordsFor(row, look.now, 0) : null);
});
rowsBox.addEventListener('pointerleave', () => { hideTip(); painted.hover.setAttribute('x1', -9); painted.hover.setAttribute('x2', -9); });
rowsBox.addEventListener('scroll', () => { if (rowsBox.classList.contains('tall')) repaint('rows', 'cursor'); });
// No dblclick: what was clicked first has been drawn anew by then, and browsers take that for another place.
rowsBox.addEventListener('mousedown', (event) => {
  if (event.detail === 2) zoom(event.shiftKey ? 2.5 : 0.4, timeAt(Math.max(localX(rowsBox, event), geometry.gutter)));
});
rowsBox.addEventListener('wheel', (event) => {
  const sideways = event.shiftKey && !event.deltaX ? event.deltaY : event.deltaX;
  if (event.ctrlKey || event.metaKey) {
    event.preventDefault();
    zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.004), timeAt(Math.max(localX(rowsBox, event), geometry.gutter)));
  } else if (Math.abs(sideways) > Math.abs(event.shiftKey ? 0 : event.deltaY)) {
    event.preventDefault();
    pan(sideways / plotWidth());
  }
}, {passive: false});
drag(rowsBox, (event) => {
  const x = localX(rowsBox, event), from = look.from, to = look.to;
  let dragged = false;
  return (next, over) => {
    const by = localX(rowsBox, next) - x;
    dragged = dragged || Math.abs(by) > 4;
    if (dragged && x >= geometry.gutter) {
      showWindow(from - by / plotWidth() * (to - from), to - by / plotWidth() * (to - from));
    } else if (over && !dragged) {
      const row = rowAt(event), time = timeAt(x);
      if (row && (row.kind === 'robot' || row.kind === 'task')) select({kind: row.kind, name: row.name, row});
      if (x < geometry.gutter) return;
      const near = 9 * (look.to - look.from) / plotWidth();
      const hit = row && row.kind === 'incidents' ? incidents.findIndex((each) => Math.abs(each.from - time) < near) : -1;
      if (hit >= 0) goToIncident(hit); else choose(time, true);
    }
  };
});
