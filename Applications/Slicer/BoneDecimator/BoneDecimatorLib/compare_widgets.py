# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The section that compares two models. Needs Slicer's window."""

import qt
import slicer


class CompareWidgets:
    """Reference, result and tolerance, and the text of the comparison."""

    def __init__(self, form, nodes, number, start):
        """@param nodes, number Make a node selector and a box for mm.  @param start Called by the button."""
        self.reference, self.result = nodes(["vtkMRMLModelNode"]), nodes(["vtkMRMLModelNode"])
        self.tolerance = number(0.0, 100.0)
        self.tolerance.toolTip = "How far any point of one surface may be from the other. 0: none; the distance is proved all the same."
        button = qt.QPushButton("Prove the distance")
        button.toolTip = "Of any two models, whatever made them. Nothing is simplified."
        button.clicked.connect(lambda _checked=False: start())
        self.text = qt.QLabel()
        self.text.wordWrap = True
        for label, widget in (("Reference", self.reference), ("Result", self.result), ("Tolerance", self.tolerance)):
            form.addRow(label, widget)
        form.addRow(button)
        form.addRow(self.text)

    def run(self, logic, progress):
        """@return The model nodes that have distances now."""
        nodes, lines = logic.compare(self.reference.currentNode(), self.result.currentNode(), self.tolerance.value or None, progress)
        self.text.text = "\n".join(lines)
        return nodes


def with_progress(title, work):
    """Calls work with a function that shows the fraction done and says whether to go on."""
    dialog = slicer.util.createProgressDialog(labelText=title, maximum=100, windowModality=qt.Qt.WindowModal)

    def tell(fraction):
        dialog.value = int(100 * fraction)
        slicer.app.processEvents()
        return not dialog.wasCanceled

    try:
        return work(tell)
    finally:
        dialog.close()
