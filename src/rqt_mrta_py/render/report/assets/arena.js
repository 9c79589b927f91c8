// The arena at the chosen moment: walls, obstacles, places of tasks, loose bodies, robots with their trails.
const arenaBox = byId('arena');
const trailLength = 60000, manyRobots = 40;
let arenaWidth = 480;

function extent() {
  if (data.arena) return data.arena;
  const xs = [], ys = [];
  for (const robot of robots) {
    if (!robot.track) continue;
    for (const value of robot.track[1]) xs.push(value * data.resolution);
    for (const value of robot.track[2]) ys.push(value * data.resolution);
  }
  for (const task of tasks) if (task.place) { xs.push(task.place[0]); ys.push(task.place[1]); }
  if (!xs.length) return [-1, -1, 1, 1];
  const low = (values) => values.reduce((a, b) => Math.min(a, b)), high = (values) => values.reduce((a, b) => Math.max(a, b));
  const pad = Math.max(high(xs) - low(xs), high(ys) - low(ys), 1) * 0.06;
  return [low(xs) - pad, low(ys) - pad, high(xs) + pad, high(ys) + pad];
}
const bounds = extent();
const floorPlan = {left: 30, top: 8, bottom: 24, right: 8};

function arenaScale() {
  const [minX, minY, maxX, maxY] = bounds;
  const room = arenaWidth - floorPlan.left - floorPlan.right;
  const scale = Math.min(room / Math.max(maxX - minX, 1e-6), 520 / Math.max(maxY - minY, 1e-6));
  const left = floorPlan.left + (room - (maxX - minX) * scale) / 2;
  return {
    scale, left, width: (maxX - minX) * scale, height: (maxY - minY) * scale,
    x: (value) => left + (value - minX) * scale,
    y: (value) => floorPlan.top + (maxY - value) * scale,
  };
}

painters.arena = () => {
  if (!hasPlaces) return;
  const plan = arenaScale(), full = plan.height + floorPlan.top + floorPlan.bottom;
  const svg = draw('svg', {viewBox: `0 0 ${arenaWidth} ${full}`, width: arenaWidth, height: full, role: 'img', 'aria-label': `The arena at ${seconds(look.now)}`});
  paintFloor(svg, plan);
  const places = tasks.filter((task) => task.place).map((task) => paintTask(svg, plan, task)).filter(Boolean);
  paintBodies(svg, plan);
  const seen = [];
  for (const robot of robots) {
    const pose = poseAt(robot, look.now);
    if (pose) seen.push({robot, x: plan.x(pose.x), y: plan.y(pose.y), yaw: pose.yaw, radius: Math.max(robot.radius * plan.scale, robots.length > 200 ? 2.5 : 6)});
  }
  const chosen = look.selected && look.selected.kind === 'robot' ? look.selected.name : null;
  for (const each of seen) {
    if (each.robot.id === chosen) svg.append(draw('path', {d: wholeWay(each.robot, plan), class: 'whole-way'}));
    if (robots.length <= manyRobots || each.robot.id === chosen) paintTrail(svg, plan, each.robot);
  }
  for (const each of seen) paintRobot(svg, each, each.robot.id === chosen);
  const named = seen.filter(({robot}) => seen.length <= manyRobots || robot.id === chosen)
    .map(({robot, x, y, radius}) => ({text: robot.id, x, y, radius, font: '600 12px', dress: 'robot-name halo', may: false}));
  paintNames(svg, [...named, ...(tasks.length > 60 ? [] : places)], [...seen, ...places], plan);
  arenaBox.replaceChildren(svg);
};

function paintFloor(svg, plan) {
  const [minX, minY, maxX, maxY] = bounds;
  svg.append(draw('rect', {x: plan.left, y: floorPlan.top, width: plan.width, height: plan.height, class: 'floor'}));
  const step = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000, 1e4, 1e5, 1e6].find((each) => each * plan.scale >= 42) || 1e7;
  for (let value = Math.ceil(minX / step) * step; value <= maxX; value += step) {
    svg.append(draw('line', {x1: plan.x(value), x2: plan.x(value), y1: floorPlan.top, y2: floorPlan.top + plan.height, class: 'mesh'}));
    svg.append(draw('text', {x: plan.x(value), y: floorPlan.top + plan.height + 15, class: 'metres'}, Number(value.toFixed(3))));
  }
  for (let value = Math.ceil(minY / step) * step; value <= maxY; value += step) {
    svg.append(draw('line', {x1: plan.left, x2: plan.left + plan.width, y1: plan.y(value), y2: plan.y(value), class: 'mesh'}));
    svg.append(draw('text', {x: plan.left - 6, y: plan.y(value) + 4, class: 'metres y'}, Number(value.toFixed(3))));
  }
  for (const [x, y, yaw, length, width, round] of data.obstacles) {
    svg.append(round
      ? draw('circle', {cx: plan.x(x), cy: plan.y(y), r: length / 2 * plan.scale, class: 'obstacle'})
      : draw('rect', {x: -length / 2 * plan.scale, y: -width / 2 * plan.scale, width: length * plan.scale, height: width * plan.scale, class: 'obstacle', transform: `translate(${plan.x(x)} ${plan.y(y)}) rotate(${-yaw * 180 / Math.PI})`}));
  }
  svg.append(draw('rect', {x: plan.left, y: floorPlan.top, width: plan.width, height: plan.height, class: data.arena ? 'wall' : 'edge'}));
}

function paintTask(svg, plan, task) {
  const state = taskState(task, look.now);
  if (!state) return null;
  const x = plan.x(task.place[0]), y = plan.y(task.place[1]), size = tasks.length > 60 ? 4 : 7;
  const over = ['done', 'failed', 'withdrawn'].includes(state);
  const group = draw('g', {class: `place ${state}`});
  group.append(draw('path', {d: `M${x},${y - size}l${size},${size}l${-size},${size}l${-size},${-size}z`, class: `diamond t${task.colour}`}));
  group.dataset.task = task.number;
  svg.append(group);
  return {text: over ? `${data.names.stages[state]} ${task.id}` : task.id, x, y, radius: size, font: '11px', dress: `place-name halo${over ? ' over' : ''}`, may: over};
}

// What lies higher comes later, and is paler; what was taken away is not there.
function paintBodies(svg, plan) {
  const there = bodies.map((body) => ({body, at: lastUntil(body.places[0], look.now)})).filter(({body, at}) => at >= 0 && body.places[3][at] !== goneBody);
  for (const each of there) each.lift = each.body.places[5][each.at] * data.resolution;
  there.sort((a, b) => a.lift - b.lift);
  for (const {body, at, lift} of there) {
    const x = plan.x(body.places[1][at] * data.resolution), y = plan.y(body.places[2][at] * data.resolution);
    const ahead = Math.max(body.length * plan.scale / 2, 3), aside = Math.max(body.width * plan.scale / 2, 3);
    const dress = `body b${body.colour}${body.places[3][at] ? ' held' : ''}`;
    const box = {x: -ahead, y: -aside, width: 2 * ahead, height: 2 * aside, transform: `translate(${x} ${y}) rotate(${-body.places[4][at]})`};
    const shape = draw('rect', {...box, class: dress});
    shape.dataset.body = body.id;
    svg.append(shape);
    if (lift > 0 && !body.places[3][at]) svg.append(draw('rect', {...box, class: 'lifted', opacity: Math.min(lift / 0.3, 1) * 0.7}));
  }
}

const wholeWay = (robot, plan) => Array.from(robot.track[0], (_, at) => `${at ? 'L' : 'M'}${plan.x(robot.track[1][at] * data.resolution).toFixed(1)},${plan.y(robot.track[2][at] * data.resolution).toFixed(1)}`).join('');

// The last minute's way, in the colour of the task that was held, paler the longer ago.
function paintTrail(svg, plan, robot) {
  const since = Math.max(look.now - trailLength, robot.track[0][0]);
  if (since >= look.now) return;
  const times = new Set([since, look.now]);
  for (let at = lastUntil(robot.track[0], since) + 1; at < robot.track[0].length && robot.track[0][at] < look.now; at++) times.add(robot.track[0][at]);
  for (const each of robot.held) for (const time of [each.from, each.to]) if (time > since && time < look.now) times.add(time);
  for (const age of [1 / 3, 2 / 3]) times.add(look.now - trailLength * age);
  const order = [...times].filter((time) => time >= since).sort((a, b) => a - b);
  let pieces = [], dress = '';
  const finish = () => { if (pieces.length > 1) svg.append(draw('path', {d: 'M' + pieces.join('L'), class: `trail ${dress}`})); };
  for (let at = 0; at + 1 < order.length; at++) {
    const held = heldAt(robot.held, order[at]), task = held.length ? tasks[held[held.length - 1].task] : null;
    const next = `${task ? `t${task.colour}` : 'free'} age${Math.min(Math.floor((look.now - order[at] - 1) / (trailLength / 3)), 2)}`;
    const point = poseAt(robot, order[at]), to = poseAt(robot, order[at + 1]);
    const text = (each) => `${plan.x(each.x).toFixed(1)},${plan.y(each.y).toFixed(1)}`;
    if (next !== dress) { finish(); pieces = [text(point)]; dress = next; }
    pieces.push(text(to));
  }
  finish();
}

function paintRobot(svg, {robot, x, y, yaw, radius}, chosen) {
  const state = robotState(robot, look.now), held = heldAt(robot.held, look.now);
  const group = draw('g', {class: 'robot'});
  group.dataset.robot = robot.number;
  const cos = Math.cos(yaw), sin = -Math.sin(yaw), far = radius + 10, half = radius * 0.9;
  if (chosen) group.append(draw('circle', {cx: x, cy: y, r: radius + 9, class: 'halo-ring'}));
  if (radius >= 4) group.append(draw('path', {d: `M${x + far * cos},${y + far * sin}L${x - half * sin},${y + half * cos}L${x + half * sin},${y - half * cos}z`, class: 'nose'}));
  const task = held.length ? tasks[held[held.length - 1].task] : null;
  group.append(draw('circle', {cx: x, cy: y, r: radius + 2, class: task ? `ring t${task.colour}` : 'ring free'}));
  group.append(light(x, y, radius - 0.5, state));
  svg.append(group);
}

// Names stand where they cover neither a sign nor another name; where there is no such place, on the right, or nowhere.
function paintNames(svg, named, signs, plan) {
  const taken = signs.map(({x, y, radius}) => [x - radius - 2, y - radius - 2, x + radius + 2, y + radius + 2]);
  for (const {text, x, y, radius, font, dress, may} of named) {
    const word = fitted(text, font, 130), width = textWidth(word, font), gap = radius + 5;
    const spots = [[x + gap, y + 4], [x - gap - width, y + 4], [x - width / 2, y - gap - 1], [x - width / 2, y + gap + 10]];
    const boxOf = ([left, base]) => [left, base - 10, left + width, base + 3];
    const free = spots.find((spot) => {
      const box = boxOf(spot);
      return box[0] >= plan.left && box[2] <= plan.left + plan.width && !taken.some((other) => box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]);
    });
    if (!free && may) continue;
    const spot = free || spots[0];
    taken.push(boxOf(spot));
    svg.append(draw('text', {x: spot[0], y: spot[1], class: dress}, word));
  }
}

arenaBox.addEventListener('pointermove', (event) => {
  const robot = event.target.closest('[data-robot]'), task = event.target.closest('[data-task]'), body = event.target.closest('[data-body]');
  if (robot) return showTip(event, wordsFor({kind: 'robot', name: robots[robot.dataset.robot].id, robot: robots[robot.dataset.robot]}, look.now, 500));
  if (task) return showTip(event, wordsFor({kind: 'task', name: tasks[task.dataset.task].id, task: tasks[task.dataset.task]}, look.now, 500));
  return body ? showTip(event, [body.dataset.body]) : hideTip();
});
arenaBox.addEventListener('pointerleave', hideTip);
arenaBox.addEventListener('click', (event) => {
  const robot = event.target.closest('[data-robot]');
  if (robot) select({kind: 'robot', name: robots[robot.dataset.robot].id});
});
