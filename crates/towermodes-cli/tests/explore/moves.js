// A reader of the page who does anything: sliders, fields, keys, buttons, tabs. `window.moves`
// gives what was wrong; a seed makes the moves the same again.
(() => {
  // What a reader typed is quoted.
  const isAbsurd = (text) => /\b(NaN|null|undefined|Infinity)\b|\[object /.test(text.replace(/“[^”]*”/g, ''));
  const wrong = new Set();
  const log = [];
  const LONGEST_MS = 60e3;
  const pause = (ms) => new Promise((next) => setTimeout(next, ms));

  // What the program answers.
  const asked = window.fetch.bind(window);
  window.fetch = async (question, options) => {
    const reply = await asked(question, options);
    const text = await reply.clone().text().catch(() => null);
    if (text === null) return reply;
    const what = `${question}: status ${reply.status}`;
    if (!reply.ok && (reply.status >= 500 || text.trim() === '')) wrong.add(`${what}, “${text.slice(0, 80)}”`);
    if (reply.headers.get('Content-Type') !== 'application/json') return reply;
    const { refused } = JSON.parse(text);
    if (refused && !refused.message?.trim()) wrong.add(`${what}, refused without a message`);
    return reply;
  };

  // What files are made is not saved.
  HTMLAnchorElement.prototype.click = function () { window.filesTaken = (window.filesTaken ?? 0) + 1; };

  const all = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility() && !one.disabled);
  const send = (element, kind) => element.dispatchEvent(new Event(kind, { bubbles: true }));

  /** The texts of the page, with those for other senses. */
  const texts = () => {
    const said = [...document.querySelectorAll('body *')].flatMap((one) => ['aria-label', 'aria-valuetext', 'title', 'd', 'x', 'y', 'points', 'transform', 'style']
      .map((name) => one.getAttribute(name) ?? ''));
    const fields = [...document.querySelectorAll('input')].filter((one) => one !== document.activeElement).map((one) => one.value);
    return [...said, ...fields].filter((text) => isAbsurd(text)).map((text) => text.slice(0, 120));
  };
  const words = () => isAbsurd(document.body.textContent) ? [...document.querySelectorAll('body *')]
    .filter((one) => one.children.length === 0 && !['SCRIPT', 'STYLE'].includes(one.tagName) && isAbsurd(one.textContent)).map((one) => `${one.tagName} ${one.textContent.slice(0, 120)}`) : [];

  /** Results are those of the values that are set, or they are greyed. */
  const belongs = () => {
    const { answer, isCurrent, pending, turbine } = window.towermodes;
    if (pending || answer === null) return [];
    const found = [];
    const isStale = document.body.classList.contains('stale');
    if (isStale === isCurrent) found.push(isCurrent ? 'greyed, but those of the values' : 'of other values, and not greyed');
    if (isStale !== (document.querySelector('#readout-state').textContent !== '')) found.push('greyed without words');
    const shown = [...document.querySelectorAll('#modes tbody tr .frequency')].map((cell) => cell.textContent.trim());
    const right = answer.modes.map((mode) => mode.frequency);
    if (JSON.stringify(shown) !== JSON.stringify(right)) found.push(`table ${shown}, answer ${right}`);
    for (const id of ['turbine', 'readout']) {
      if (isCurrent && document.getElementById(id).classList.contains('old')) found.push(`#${id} is marked as old at rest`);
    }
    if (!isStale && turbine === null && document.body.classList.contains('unjudged')) found.push('no verdict, and nothing is to come');
    // A field and its slider have the value of the answer.
    if (!isStale) for (const row of document.querySelectorAll('.row[id^="number-"]')) {
      if (!row.closest('details').open) continue;
      const value = answer.values[Number(row.id.slice(7))];
      const [field, slider] = [row.querySelector('.field'), row.querySelector('input[type=range]')];
      if (field === document.activeElement || !Number.isFinite(value) || row.querySelector('[aria-invalid]')) continue;
      const typed = Number(field.value);
      if (Math.abs(typed - value) > 1e-6 * Math.abs(value)) found.push(`field ${row.id}: ${field.value}, answer ${value}`);
      if (Math.abs(Number(slider.value) - value) > Number(slider.step) * 0.51) found.push(`slider ${row.id}: ${slider.value}, answer ${value}`);
    }
    return found;
  };

  const check = (isThorough) => {
    for (const found of [...words(), ...(isThorough ? texts() : []), ...belongs()]) wrong.add(`${found} (after ${log.join('; ')})`);
  };

  /** Waits until every answer is there. */
  const rest = async () => {
    const begun = performance.now();
    while (window.towermodes.pending && performance.now() - begun < LONGEST_MS) await pause(2);
    if (window.towermodes.pending) wrong.add(`no answer within a minute (after ${log.join('; ')})`);
    await pause(2);
    check(true);
  };

  const NONSENSE = ['', 'a tower', '1,5', '60 mm', '1e999', '--1', '0x10', 'NaN', 'Infinity', '\u2212', '1e-320'];

  window.moves = async (seed, count, { isHeavy = false } = {}) => {
    wrong.clear();
    let state = seed * 7919 + 1;
    const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
    const pick = (list) => list[Math.floor(random() * list.length)];
    const within = (slider) => Number(slider.min) + (Number(slider.max) - Number(slider.min)) * random();
    const kinds = {
      slider: [30, () => {
        const slider = pick(all('#groups input[type=range]'));
        if (!slider) return;
        slider.value = within(slider);
        send(slider, 'input');
        if (random() < 0.5) send(slider, 'change');
        return slider.closest('.row').id;
      }],
      field: [15, () => {
        const field = pick(all('#groups .field'));
        if (!field) return;
        field.focus();
        const value = Number(field.value);
        const odd = random();
        field.value = odd < 0.2 ? pick(NONSENSE) : odd < 0.3 ? '0' : odd < 0.4 ? String(-value) : (value * (0.5 + random())).toPrecision(4);
        const typed = field.value;
        send(field, 'input');
        if (random() < 0.8) send(field, 'change');
        if (random() < 0.8) field.blur();
        return `${field.closest('.row').id} = ${typed}`;
      }],
      key: [8, () => {
        const keys = ['1', '2', '5', '9', ' ', 't', '/', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Enter', 'Escape', 'z', 'y'];
        const key = pick(keys);
        const at = pick([document.activeElement, document.body, document.querySelector('#diagram'), document.querySelector('canvas'), ...all('#groups .field').slice(0, 3)].filter(Boolean));
        at.focus?.();
        const event = { key, ctrlKey: 'zy'.includes(key), shiftKey: random() < 0.2, bubbles: true, cancelable: true };
        at.dispatchEvent(new KeyboardEvent('keydown', event));
        return `${key} on ${at.id || at.tagName}`;
      }],
      fold: [8, () => {
        const details = pick(all('details'));
        details.open = !details.open;
        return details.id || details.textContent.slice(0, 20);
      }],
      back: [4, () => pick(all('.row .back'))?.click()],
      tool: [10, () => {
        const button = pick(all('#undo, #redo, #keep, #theme, #play, #one-mode, #after-tap, #camera, #enlarge, #compare button, #help, dialog button, .notice button'));
        button?.click();
        return button?.textContent;
      }],
      reset: [0.5, () => document.querySelector('#reset').click()],
      mode: [8, () => pick(all('#modes input, #whirls input'))?.click()],
      motion: [6, () => {
        const slider = pick(all('#amplitude, #speed, #rotor-speed'));
        if (!slider) return;
        slider.value = within(slider);
        send(slider, 'input');
        return slider.id;
      }],
      search: [2, () => {
        const search = document.querySelector('#filter');
        search.value = pick(['', '', 'wall', 'mass', 'station', '[*]', '(', 'nothing at all']);
        send(search, 'input');
        return search.value;
      }],
      mark: [2, () => pick(all('.row .pick'))?.click()],
      diagram: [3, () => {
        const diagram = document.querySelector('#diagram');
        const box = diagram.getBoundingClientRect();
        const at = { clientX: box.x + random() * box.width, clientY: box.y + random() * box.height, bubbles: true };
        diagram.dispatchEvent(new PointerEvent('pointermove', at));
        if (random() < 0.4) diagram.dispatchEvent(new MouseEvent('click', at));
        else if (random() < 0.5) diagram.dispatchEvent(new PointerEvent('pointerleave', at));
      }],
      take: [isHeavy ? 0.5 : 0.2, () => {
        const button = pick([...document.querySelectorAll('#take-list button')].filter((one) => !/film/.test(one.getAttribute('aria-label') ?? '')));
        button.click();
        return button.getAttribute('aria-label') ?? button.textContent;
      }],
      table: [0.5, () => pick(all('[data-table] button'))?.click()],
      address: [0.5, () => {
        const text = pick(['', '#', '#rna.mass=300000', '#rna.mas=1', '#stations%5B1%5D.wall=x', '#%', '#a=b=c&']);
        location.hash = text;
        return text;
      }],
      target: [isHeavy ? 0.2 : 0.05, async () => {
        const target = document.querySelector('#target');
        target.open = true;
        const [low, high] = ['#target-low', '#target-high'].map((id) => document.querySelector(id));
        low.value = pick(['', 'x', (0.1 + random()).toFixed(3)]);
        high.value = pick(['', '', (0.1 + random()).toFixed(3)]);
        document.querySelector('#target-find').click();
        await pause(200 * random());
        document.querySelector('#target-cancel').click();
      }],
    };
    const whole = Object.values(kinds).reduce((sum, [weight]) => sum + weight, 0);
    for (let move = 0; move < count; move++) {
      let at = random() * whole;
      const [name, [, act]] = Object.entries(kinds).find(([, [weight]]) => (at -= weight) < 0) ?? Object.entries(kinds)[0];
      try {
        const on = await act();
        log.push(`${name} ${on ?? ''}`.trim());
        if (log.length > 3) log.shift();
      } catch (error) {
        wrong.add(`${name}: ${error.stack ?? error}`);
      }
      for (const dialog of document.querySelectorAll('dialog[open]')) if (random() < 0.7) dialog.close();
      const wait = random();
      if (wait < 0.15) await rest();
      else await pause(wait < 0.6 ? 0 : 20 * random());
      if (wait >= 0.15) check(false);
    }
    await rest();
    for (const said of document.querySelectorAll('#notices .notice')) {
      if (/TypeError|ReferenceError|does not answer|status \d|not answered/.test(said.textContent)) wrong.add(`notice: ${said.textContent}`);
    }
    return [...wrong];
  };
})()
