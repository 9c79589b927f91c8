// Small charts of an architecture's inner life, on the timeline's own axis.
function curveAt(curve, time) {
  const [times, levels] = curve.points, at = lastUntil(times, time);
  if (at < 0 || levels[at] < 0) return null;
  if (at + 1 >= times.length) return time - times[at] < 1000 ? levels[at] : null;
  if (levels[at + 1] < 0) return time === times[at] ? levels[at] : null;
  const share = (time - times[at]) / Math.max(times[at + 1] - times[at], 1);
  return levels[at] + (levels[at + 1] - levels[at]) * share;
}
const chartTop = (row) => row.top + 8, chartBottom = (row) => row.top + row.height - 6;
const yOf = (row, level) => chartBottom(row) - clamp(level / row.panel.levels, 0, 1.06) * (chartBottom(row) - chartTop(row));

function paintCurves(row, names, plot) {
  name(row, names, 0);
  const {panel} = row, right = geometry.gutter - 5;
  const marked = panel.reference !== null && panel.reference > 0 && panel.reference <= panel.top ? panel.reference : panel.top;
  names.append(draw('text', {x: right, y: yOf(row, marked / panel.top * panel.levels) + 4, class: 'value'}, String(Number(marked.toPrecision(3)))));
  names.append(draw('text', {x: right, y: chartBottom(row), class: 'value'}, panel.unit === '1' ? '0' : `0 ${panel.unit}`));
  names.append(draw('line', {x1: geometry.gutter, x2: geometry.width - 20, y1: chartBottom(row), y2: chartBottom(row), class: 'rule'}));
  if (panel.reference !== null) {
    const y = yOf(row, panel.reference / panel.top * panel.levels);
    plot.append(draw('line', {x1: geometry.gutter, x2: geometry.width, y1: y, y2: y, class: 'reference'}));
  }
  for (const curve of row.group.curves) {
    const path = strokes(row, curve.points);
    if (path) plot.append(draw('path', {d: path, class: `curve t${curve.colour}`}));
  }
}
// Where points crowd, a column of pixels has its lowest and its highest only, in their order.
function strokes(row, [times, levels]) {
  const first = Math.max(lastUntil(times, look.from), 0), last = Math.min(lastUntil(times, look.to) + 1, times.length - 1);
  const short = (value) => Math.round(value * 10) / 10;
  const pieces = [];
  let column = null;
  const finish = () => {
    if (!column) return;
    const [from, to] = column.low[0] <= column.high[0] ? [column.low, column.high] : [column.high, column.low];
    pieces.push(`${column.down ? 'L' : 'M'}${short(from[0])},${short(from[1])}L${short(to[0]) + (column.lone ? 0.1 : 0)},${short(to[1])}`);
    column = null;
  };
  let down = false;
  for (let at = first; at <= last; at++) {
    if (levels[at] < 0) { finish(); down = false; continue; }
    const point = [xOf(times[at]), yOf(row, levels[at])], place = Math.floor(point[0]);
    if (column && column.place === place) {
      column.lone = false;
      if (point[1] < column.low[1]) column.low = point;
      if (point[1] > column.high[1]) column.high = point;
      continue;
    }
    finish();
    column = {place, low: point, high: point, down, lone: !down && (at === last || levels[at + 1] < 0)};
    down = true;
  }
  finish();
  return pieces.join('');
}
function curveDots(row, time) {
  const dots = [];
  for (const curve of row.group.curves) {
    const level = curveAt(curve, time);
    if (level !== null) dots.push(draw('circle', {cx: xOf(time), cy: yOf(row, level), r: 3, class: `dot t${curve.colour}`}));
  }
  return dots;
}
