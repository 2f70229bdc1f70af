// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The value of the surface under a mouse that rests.

const REST = 40; // milliseconds

/** @param textAt Gives the text for a position of the stage; empty: none. */
export function showUnderCursor(stage, label, textAt) {
  let timer = 0;
  const hide = () => {
    clearTimeout(timer);
    label.hidden = true;
  };
  const showAt = (x, y) => {
    label.textContent = textAt([x, y]);
    label.hidden = label.textContent === '';
    const left = Math.min(x + 14, stage.clientWidth - label.offsetWidth - 4);
    label.style.transform = `translate(${left}px, ${Math.max(0, y - 30)}px)`;
  };
  stage.addEventListener('pointermove', (event) => {
    hide();
    if (event.pointerType === 'mouse' && event.buttons === 0) {
      const box = stage.getBoundingClientRect();
      timer = setTimeout(showAt, REST, event.clientX - box.left, event.clientY - box.top);
    }
  });
  stage.addEventListener('pointerleave', hide);
  stage.addEventListener('pointerdown', hide);
}
