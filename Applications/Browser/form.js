// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The form of the options: a field for each row of the option table, the first ones in sight and the others folded away.

const FIRST = ['maxError', 'targetTriangles', 'mode', 'smooth'];
const LABELS = {
  maxError: 'Largest error, mm',
  targetTriangles: 'Number of triangles',
  mode: 'Mode',
  smooth: 'Smoothing of the staircase, mm',
};

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

function choicesOf(row) {
  const choices = row.kind === 'boolean' ? ['on', 'off'] : row.choices;
  const empty = make('option', { value: '', textContent: `default (${row.default})` });
  return make('select', {}, empty, ...choices.map((choice) => make('option', { value: choice, textContent: choice })));
}

function fieldOf(row) {
  const hasChoices = row.kind === 'boolean' || row.kind === 'choice';
  const field = hasChoices ? choicesOf(row) : make('input', { type: 'text', inputMode: 'decimal', placeholder: row.default });
  field.name = row.name;
  field.id = `option-${row.name}`;
  const unit = row.unit && !LABELS[row.name] ? `, ${row.unit}` : '';
  const text = LABELS[row.name] ?? `${row.name}${unit}`;
  return make('label', { title: row.description }, make('span', { textContent: text }), field);
}

export function fillForm(rows, main, more) {
  const isFirst = (row) => FIRST.includes(row.name);
  const order = (row) => FIRST.indexOf(row.name);
  main.append(...rows.filter(isFirst).sort((a, b) => order(a) - order(b)).map(fieldOf));
  more.append(...rows.filter((row) => !isFirst(row)).map(fieldOf));
}

/** The options that were filled in, as text: the core reads and checks them. */
export function optionsOf(form) {
  const fields = [...form.elements].filter((field) => field.name && field.value.trim() !== '');
  return Object.fromEntries(fields.map((field) => [field.name, field.value.trim()]));
}
