// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The form beside the canvas; page.html has its elements.

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

/** The bar of colors, from 0 to the end of the range. */
export function addLegend({ range, colors }) {
  const stops = colors.filter((_, index) => index % 15 === 0).map((color) => `rgb(${color})`);
  find('viewer-bar').style.background = `linear-gradient(to right, ${stops})`;
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((fraction) => String(Number((fraction * range).toPrecision(3))));
  find('viewer-ticks').replaceChildren(
    ...ticks.map((tick) => {
      const element = document.createElement('span');
      element.textContent = tick;
      return element;
    })
  );
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
