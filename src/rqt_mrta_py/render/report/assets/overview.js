// The whole mission in one strip: how many robots are busy, where incidents are, which window is shown; and the ruler.
const overviewBox = byId('overview'), axisBox = byId('axis');
const overviewHeight = 34, axisHeight = 30;
const wholeX = (time) => geometry.gutter + time / end * plotWidth();
const wholeTime = (x) => (x - geometry.gutter) / plotWidth() * end;

let crowd = {width: 0, path: ''};
function crowdPath() {
  const width = Math.floor(plotWidth());
  if (crowd.width === width) return crowd.path;
  const every = Math.ceil(robots.length / 200) || 1, seen = robots.filter((_, at) => at % every === 0);
  const bottom = overviewHeight - 2, room = overviewHeight - 14;
  let path = `M${geometry.gutter},${bottom}`;
  for (let x = 0; x <= width; x += 2) {
    const busy = seen.filter((robot) => robotState(robot, x / width * end) === 'busy').length;
    const y = bottom - room * busy / Math.max(seen.length, 1);
    path += `V${y.toFixed(1)}H${geometry.gutter + x + 2}`;
  }
  crowd = {width, path: `${path}V${bottom}Z`};
  return crowd.path;
}

painters.overview = () => {
  const svg = draw('svg', {viewBox: `0 0 ${geometry.width} ${overviewHeight}`, width: geometry.width, height: overviewHeight, 'aria-hidden': 'true'});
  svg.append(draw('text', {x: 0, y: 21, class: 'gutter'}, 'robots busy'));
  svg.append(draw('rect', {x: geometry.gutter, y: 0, width: plotWidth(), height: overviewHeight, class: 'ground'}));
  svg.append(draw('path', {d: crowdPath(), class: 'crowd'}));
  for (const each of incidents.slice(0, 1000)) {
    const x = wholeX(each.from);
    svg.append(draw('path', {d: `M${x},2l4,8h-8z`, class: data.names.severities[each.severity]}));
  }
  const left = wholeX(look.from), right = wholeX(look.to);
  if (look.to - look.from < end) {
    svg.append(draw('rect', {x: geometry.gutter, y: 0, width: Math.max(left - geometry.gutter, 0), height: overviewHeight, class: 'shade'}));
    svg.append(draw('rect', {x: right, y: 0, width: Math.max(geometry.gutter + plotWidth() - right, 0), height: overviewHeight, class: 'shade'}));
  }
  svg.append(draw('rect', {x: left, y: 0.75, width: Math.max(right - left, 3), height: overviewHeight - 1.5, class: 'window'}));
  for (const x of [left, right]) svg.append(draw('rect', {x: x - 3, y: overviewHeight / 2 - 7, width: 6, height: 14, rx: 2, class: 'handle'}));
  svg.append(draw('line', {x1: wholeX(look.now), x2: wholeX(look.now), y1: 0, y2: overviewHeight, class: 'now'}));
  overviewBox.replaceChildren(svg);
};

painters.axis = () => {
  const svg = draw('svg', {viewBox: `0 0 ${geometry.width} ${axisHeight}`, width: geometry.width, height: axisHeight, 'aria-hidden': 'true'});
  const name = end >= 900000 ? 'time [h:m:s]' : 'time [s]', nameEnd = textWidth(name, '12px') + 6;
  svg.append(draw('text', {x: 0, y: 20, class: 'gutter'}, name));
  const x = xOf(look.now), inside = look.now >= look.from && look.now <= look.to;
  const flag = seconds(look.now), width = textWidth(flag, '600 11px') + 12;
  const middle = clamp(x, geometry.gutter + width / 2 - 6, geometry.width - width / 2 - 1);
  for (const [time, text] of ticks()) {
    const at = xOf(time);
    svg.append(draw('line', {x1: at, x2: at, y1: axisHeight - 6, y2: axisHeight, class: 'tick'}));
    const half = textWidth(text, '11px') / 2 + 4, place = Math.max(at, nameEnd + half);
    if (!inside || Math.abs(place - middle) > width / 2 + half) svg.append(draw('text', {x: place, y: 18, class: 'tick'}, text));
  }
  if (inside) {
    svg.append(draw('path', {d: `M${x - 5},${axisHeight - 8}h10l-5,8z`, class: 'flag'}));
    svg.append(draw('rect', {x: middle - width / 2, y: 3, width, height: 19, rx: 3, class: 'flag'}));
    svg.append(draw('text', {x: middle, y: 17, class: 'flag-text'}, flag));
  }
  axisBox.replaceChildren(svg);
  axisBox.dataset.window = `${look.from / 1000} ${look.to / 1000}`;
  axisBox.setAttribute('aria-valuenow', (look.now / 1000).toFixed(1));
  const told = robots.length > 12 ? '' : robots.map((robot) => told1(robot, look.now)).join(', ');
  axisBox.setAttribute('aria-valuetext', told ? `${seconds(look.now)}: ${told}` : seconds(look.now));
};
function told1(robot, time) {
  const held = heldAt(robot.held, time).map((each) => tasks[each.task].id).join(' and ');
  return `${robot.id} ${robotState(robot, time)}${held ? ` with ${held}` : ''}`;
}

const localX = (box, event) => (event.clientX - box.getBoundingClientRect().left) * geometry.width / Math.max(box.getBoundingClientRect().width, 1);

// One finger or button, from where it goes down until it is let go.
function drag(box, begin) {
  // The keys go on working, whatever part was touched last.
  box.addEventListener('mousedown', (event) => { event.preventDefault(); axisBox.focus({preventScroll: true}); });
  box.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const moved = begin(event);
    if (!moved) return;
    try { box.setPointerCapture(event.pointerId); } catch (error) { /* a pointer that is gone already */ }
    const move = (next) => moved(next, false);
    const up = (next) => {
      box.removeEventListener('pointermove', move);
      box.removeEventListener('pointerup', up);
      box.removeEventListener('pointercancel', up);
      moved(next, true);
    };
    box.addEventListener('pointermove', move);
    box.addEventListener('pointerup', up);
    box.addEventListener('pointercancel', up);
  });
}

drag(axisBox, (event) => {
  choose(timeAt(localX(axisBox, event)), true);
  return (next) => choose(timeAt(localX(axisBox, next)), true);
});
drag(overviewBox, (event) => {
  const x = localX(overviewBox, event), from = look.from, to = look.to, at = wholeTime(x);
  const left = wholeX(from), right = wholeX(to);
  if (Math.abs(x - left) < 7) return (next) => showWindow(Math.min(wholeTime(localX(overviewBox, next)), to - shortest), to);
  if (Math.abs(x - right) < 7) return (next) => showWindow(from, Math.max(wholeTime(localX(overviewBox, next)), from + shortest));
  if (to - from < end && x > left && x < right) {
    return (next) => { const by = wholeTime(localX(overviewBox, next)) - at; showWindow(from + by, to + by); };
  }
  return (next, over) => {
    const other = wholeTime(localX(overviewBox, next));
    if (Math.abs(localX(overviewBox, next) - x) > 4) showWindow(Math.min(at, other), Math.max(at, other));
    else if (over) { choose(at, true); if (look.to - look.from < end) showWindow(at - (to - from) / 2, at + (to - from) / 2); }
  };
});
