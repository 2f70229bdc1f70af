// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The form beside the canvas; page.html has its elements.

const PLAIN = [237, 222, 194]; // the color of bone

const find = (id) => document.getElementById(id);

function checkBox(label, isChecked, onChange) {
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = isChecked;
  box.addEventListener('change', () => onChange(box.checked));
  const line = document.createElement('label');
  line.append(box, document.createTextNode(` ${label}`));
  return line;
}

/** A check box for each part, and buttons for all of them at once. */
export function addParts(parts, onChange) {
  const list = find('viewer-parts');
  const states = parts.map(() => true);
  const boxes = parts.map((part, index) =>
    checkBox(part.name, true, (isOn) => {
      states[index] = isOn;
      onChange(states);
    })
  );
  const switchAll = (isOn) => {
    boxes.forEach((box) => (box.firstChild.checked = isOn));
    states.fill(isOn);
    onChange(states);
  };
  boxes.forEach((box, index) => {
    const { color } = parts[index];
    if (color) {
      const sample = document.createElement('i');
      sample.style.background = `rgb(${color.map((value) => Math.round(255 * value))})`;
      box.insertBefore(sample, box.lastChild);
    }
    list.append(box);
  });
  find('viewer-all').addEventListener('click', () => switchAll(true));
  find('viewer-none').addEventListener('click', () => switchAll(false));
  find('viewer-parts-group').hidden = parts.length < 2;
}

/** A length of the legend in mm, rounded down, so that it never looks larger than a bound. */
export function lengthText(range, step) {
  const digits = Math.max(0, 3 - Math.ceil(Math.log10(range)));
  const scale = 10 ** digits;
  return (Math.floor((step / 255) * range * scale + 1e-6) / scale).toFixed(digits);
}

/** The bar of colors, from 0 to the end of the range, or to twice a tolerance; plain up to the threshold. */
export function drawLegend({ range, colors, isCapped, tolerance }, threshold) {
  const plain = `rgb(${PLAIN})`;
  const at = (step) => `${((100 * step) / 255).toFixed(1)}%`;
  const stops = colors.map((color, step) => [color, step]).filter(([, step]) => step >= threshold);
  const bar = [`${plain} ${at(threshold)}`, ...stops.map(([color, step]) => `rgb(${color}) ${at(step)}`)];
  find('viewer-bar').style.background = `linear-gradient(to right, ${bar})`;
  const short = (value, digits) => String(Number(value.toPrecision(digits)));
  const ticks = tolerance
    ? ['0', `tolerance ${short(tolerance, 4)}`, short(2 * tolerance, 4)]
    : [0, 0.25, 0.5, 0.75, 1].map((fraction) => short(fraction * range, 3));
  find('viewer-ticks').replaceChildren(
    ...ticks.map((tick, index) => {
      const element = document.createElement('span');
      element.textContent = isCapped && index === ticks.length - 1 ? `\u2265 ${tick}` : tick;
      return element;
    })
  );
  write('viewer-plain', threshold > 0 ? `; plain below ${lengthText(range, threshold)}` : '');
  write('viewer-threshold-text', `${lengthText(range, threshold)} mm`);
}

/** A button for each of the points where the surfaces are farthest apart. @param onChoose Gets the point, or null. */
export function addFarthest(points, onChoose) {
  const buttons = points.map((point) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${point.distance} at ${point.where}`;
    button.setAttribute('aria-pressed', 'false');
    return button;
  });
  const press = (pressed) => {
    buttons.forEach((button, index) => button.setAttribute('aria-pressed', String(index === pressed)));
    onChoose(points[pressed] ?? null);
  };
  buttons.forEach((button, index) => {
    button.addEventListener('click', () => press(button.getAttribute('aria-pressed') === 'true' ? -1 : index));
    const item = document.createElement('li');
    item.append(button);
    find('viewer-farthest').append(item);
  });
  show('viewer-farthest-group', points.length > 0);
  return () => press(-1);
}

/** Calls onInput with the element whenever the person changes it; a program's changes do not count. */
export function bind(id, onInput) {
  const element = find(id);
  element.addEventListener('input', () => onInput(element));
  return element;
}

export function bindButton(id, onClick) {
  find(id).addEventListener('click', onClick);
}

export function show(id, isShown) {
  find(id).hidden = !isShown;
}

export function write(id, text) {
  find(id).textContent = text;
}
