// The team at the chosen moment in words: who does what, and what happened last.
const momentBox = byId('moment');
const mostChips = 24, mostNews = 7;

painters.moment = () => {
  byId('now').textContent = seconds(look.now);
  byId('printed-moment').textContent = `The arena at ${seconds(look.now)}`;
  const troubled = (robot) => robotState(robot, look.now) === 'offline' ? 0 : 1;
  const order = robots.length <= mostChips ? robots : [...robots].sort((a, b) => troubled(a) - troubled(b) || a.number - b.number);
  const chips = order.slice(0, mostChips).map((robot) => {
    const state = robotState(robot, look.now), held = heldAt(robot.held, look.now).map((each) => tasks[each.task]);
    const chip = make('button', {type: 'button', class: `team ${state}`, 'aria-pressed': String(Boolean(look.selected && look.selected.kind === 'robot' && look.selected.name === robot.id))});
    const svg = draw('svg', {viewBox: '0 0 12 12', width: 12, height: 12, 'aria-hidden': 'true'});
    svg.append(light(6, 6, 5, state));
    chip.append(svg, make('b', {}, robot.id), make('span', {}, held.length ? held.map((task) => task.id).join(', ') : state));
    if (held.length) chip.querySelector('span').className = `holds t${held[held.length - 1].colour}`;
    chip.addEventListener('click', () => select(chip.getAttribute('aria-pressed') === 'true' ? null : {kind: 'robot', name: robot.id}));
    return chip;
  });
  if (robots.length > mostChips) chips.push(make('span', {class: 'more'}, `and ${robots.length - mostChips} more`));
  const last = lastUntil(eventTimes, look.now), news = [];
  for (let at = last; at >= 0 && news.length < mostNews; at--) {
    const [time, severity, text] = events[at];
    const fresh = look.now - time < 1000 ? ' fresh' : '';
    news.push(make('li', {class: data.names.severities[severity] + fresh}, make('a', {class: 'when', href: `#t=${(time / 1000).toFixed(3)}`}, seconds(time)), make('span', {}, text)));
  }
  momentBox.replaceChildren(
    make('div', {class: 'chips'}, ...chips),
    make('h3', {}, 'What happened last'),
    news.length ? make('ul', {class: 'news'}, ...news) : make('p', {class: 'calm'}, 'nothing yet'));
};
