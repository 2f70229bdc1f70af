# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panel. BoneDecimatorLib has its logic, which needs no window."""

import json

import ctk
import qt
import slicer
from BoneDecimatorLib.engines import Canceled, DecimationError, NoEngine
from BoneDecimatorLib.logic import BoneDecimatorLogic, Request, presets, report
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleTest, ScriptedLoadableModuleWidget

MODES = ("Balanced", "Fast", "Accurate")
EVERYWHERE, ONLY_THERE, KEEP = "everywhere", "only where the brush is", "everywhere but there"


class BoneDecimator(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Bone Decimator"
        parent.categories = ["Surface Models"]
        parent.contributors = ["vtkBoneDecimate contributors"]
        parent.helpText = ("Makes a surface of bone smaller and proves, in mm, how far the result is from it. "
                           "Not a medical device.")
        parent.acknowledgementText = "After H. Brandao's thesis on normal field deviation, 2018."


class BoneDecimatorWidget(ScriptedLoadableModuleWidget):
    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = BoneDecimatorLogic(slicer.mrmlScene)
        self.levels = None
        self._addSource()
        self._addGoal()
        self._addBrush()
        self._addActions()
        self.layout.addStretch(1)

    # --- the panel, part by part

    def _section(self, title, collapsed=False):
        button = ctk.ctkCollapsibleButton()
        button.text, button.collapsed = title, collapsed
        self.layout.addWidget(button)
        return qt.QFormLayout(button)

    def _nodes(self, classes, may_be_new=False):
        box = slicer.qMRMLNodeComboBox()
        box.nodeTypes = classes
        box.noneEnabled, box.addEnabled, box.removeEnabled = True, may_be_new, False
        box.setMRMLScene(slicer.mrmlScene)
        return box

    def _millimeters(self, value, largest):
        box = ctk.ctkDoubleSpinBox()
        box.minimum, box.maximum, box.decimals, box.singleStep, box.suffix = 0.0, largest, 3, 0.05, " mm"
        box.value = value
        return box

    def _addSource(self):
        form = self._section("Bone")
        self.source = self._nodes(["vtkMRMLModelNode", "vtkMRMLSegmentationNode"])
        self.segment = slicer.qMRMLSegmentSelectorWidget()
        self.segment.setMRMLScene(slicer.mrmlScene)
        self.segment.segmentationNodeSelectorVisible = False
        self.target = self._nodes(["vtkMRMLModelNode"], may_be_new=True)
        self.source.currentNodeChanged.connect(self._onSource)
        form.addRow("Model or segmentation", self.source)
        form.addRow("Segment", self.segment)
        form.addRow("Result (none: a new model)", self.target)

    def _onSource(self, node):
        is_segmentation = node is not None and node.IsA("vtkMRMLSegmentationNode")
        self.segment.enabled = is_segmentation
        self.segment.setCurrentNode(node if is_segmentation else None)
        self.levels = None

    def _addGoal(self):
        form = self._section("How small")
        self.tolerance = self._millimeters(0.2, 100.0)
        self.tolerance.toolTip = "No point of either surface is farther from the other: proved. 0: no limit."
        self.volume = self._nodes(["vtkMRMLScalarVolumeNode"])
        buttons = qt.QHBoxLayout()
        for name in presets((1.0,)):
            button = qt.QPushButton(name)
            button.clicked.connect(lambda _checked=False, name=name: self._try(lambda: self._onPreset(name)))
            buttons.addWidget(button)
        self.triangles = qt.QSpinBox()
        self.triangles.maximum, self.triangles.singleStep = 100_000_000, 1000
        self.triangles.specialValueText = "as few as the tolerance allows"
        self.mode = qt.QComboBox()
        self.mode.addItems(MODES)
        form.addRow("Tolerance", self.tolerance)
        form.addRow("Scan, for presets", self.volume)
        form.addRow("", buttons)
        form.addRow("Triangles", self.triangles)
        form.addRow("Mode", self.mode)

    def _onPreset(self, name):
        if self.volume.currentNode() is None:
            slicer.util.warningDisplay("Choose the scan first: its voxels say how large the tolerance is.")
            return
        self.tolerance.value = presets(self.volume.currentNode().GetSpacing())[name]

    def _addBrush(self):
        form = self._section("Where", collapsed=True)
        self.where = qt.QComboBox()
        self.where.addItems([EVERYWHERE, ONLY_THERE, KEEP])
        self.brush = self._nodes(["vtkMRMLMarkupsFiducialNode", "vtkMRMLMarkupsROINode"], may_be_new=True)
        self.paint = qt.QLineEdit()
        self.paint.placeholderText = "or a painted point array (Dynamic Modeler, Select by points)"
        self.radius, self.feather = self._millimeters(10.0, 1000.0), self._millimeters(2.0, 100.0)
        for label, widget in (("Simplify", self.where), ("Points or region of interest", self.brush),
                              ("Point array", self.paint), ("Radius of a point", self.radius), ("Feather", self.feather)):
            form.addRow(label, widget)

    def _addActions(self):
        form = self._section("Result")
        buttons = qt.QHBoxLayout()
        for text, action in (("Simplify", self._onSimplify), ("Undo", self._onUndo), ("Before / after", self._onToggle),
                             ("Heat map", self._onHeatMap), ("Save report", self._onReport)):
            button = qt.QPushButton(text)
            button.clicked.connect(lambda _checked=False, action=action: self._try(action))
            buttons.addWidget(button)
        self.slider = ctk.ctkSliderWidget()
        self.slider.decimals, self.slider.minimum, self.slider.maximum, self.slider.value = 0, 5, 100, 100
        self.slider.suffix, self.slider.tracking = " % of the triangles", False
        self.slider.valueChanged.connect(lambda value: self._try(lambda: self._onLevel(value)))
        self.text = qt.QLabel()
        self.text.wordWrap = True
        form.addRow(buttons)
        form.addRow("Levels of detail", self.slider)
        form.addRow(self.text)

    # --- what the buttons do

    def request(self):
        where, brush = self.where.currentText, None
        if where != EVERYWHERE:
            brush = self.paint.text.strip() or self.brush.currentNode()
            if not brush:
                raise DecimationError("Choose points, a region of interest or a point array under 'Where'.")
        return Request(tolerance=self.tolerance.value, triangles=self.triangles.value, mode=self.mode.currentText,
                       brush=brush, keeps_brush=where == KEEP, radius=self.radius.value, feather=self.feather.value)

    def _try(self, action):
        try:
            action()
        except Canceled:
            self.text.text = "Canceled; nothing has changed."
        except DecimationError as problem:
            self._offerWheel(problem)

    def _offerWheel(self, problem):
        """Installs the wheel from a file of the user: no public index has it."""
        if not isinstance(problem, NoEngine):
            slicer.util.errorDisplay(str(problem))
        elif slicer.util.confirmOkCancelDisplay(f"{problem}\n\nChoose the wheel now?"):
            wheel = qt.QFileDialog.getOpenFileName(None, "The wheel", "", "Wheels (bonedecimate-*.whl)")
            if wheel:
                slicer.util.pip_install(f'"{wheel}"')

    def _onSimplify(self):
        dialog = slicer.util.createProgressDialog(labelText="Simplifying", maximum=100, windowModality=qt.Qt.WindowModal)

        def tell(fraction):
            dialog.value = int(100 * fraction)
            slicer.app.processEvents()
            return not dialog.wasCanceled

        try:
            node, lines = self.logic.decimate(self.source.currentNode(), self.request(), self.target.currentNode(),
                                              self.segment.currentSegmentID() or None, tell)
        finally:
            dialog.close()
        node.CreateDefaultDisplayNodes()
        self.target.setCurrentNode(node)
        self.text.text = "\n".join(lines)

    def _onUndo(self):
        if self.logic.can_undo():
            self.target.setCurrentNode(self.logic.undo())
            self.text.text = ""

    def _onToggle(self):
        before, after = self.source.currentNode(), self.target.currentNode()
        if before and after and before.GetDisplayNode() and after.GetDisplayNode():
            shown = after.GetDisplayNode().GetVisibility()
            after.GetDisplayNode().SetVisibility(not shown)
            before.GetDisplayNode().SetVisibility(shown)

    def _onHeatMap(self):
        node = self.target.currentNode()
        if node is None or node.GetPolyData().GetPointData().GetArray("Distance") is None:
            raise DecimationError("Simplify first: there is no distance to show.")
        display = node.GetDisplayNode()
        display.SetActiveScalar("Distance", 0)
        display.SetAndObserveColorNodeID("vtkMRMLColorTableNodeFileViridis.txt")
        display.SetScalarVisibility(True)
        legend = slicer.modules.colors.logic().AddDefaultColorLegendDisplayNode(node)
        legend.SetTitleText("distance to the original, mm")

    def _onLevel(self, percent):
        source, target = self.source.currentNode(), self.target.currentNode()
        if source is None or target is None or target is source:
            return
        if self.levels is None:
            with slicer.util.WaitCursor():
                self.levels = self.logic.record_levels(source, segment=self.segment.currentSegmentID() or None)
        self.logic.show_level(self.levels, int(percent / 100.0 * self.levels.result.report["input.triangles"]), target)
        self.text.text = f"{target.GetPolyData().GetNumberOfPolys():,} triangles"

    def _onReport(self):
        node = self.target.currentNode()
        path = qt.QFileDialog.getSaveFileName(None, "Save report", "report.json", "JSON (*.json)") if node else ""
        if path:
            with open(path, "w", encoding="utf-8") as file:
                file.write(json.dumps(report(node.GetPolyData()), indent=2) + "\n")


class BoneDecimatorTest(ScriptedLoadableModuleTest):
    def runTest(self):
        import vtk
        source = vtk.vtkSphereSource()
        source.SetRadius(20.0)
        source.SetThetaResolution(60)
        source.SetPhiResolution(60)
        source.Update()
        node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLModelNode", "bone")
        node.SetAndObservePolyData(source.GetOutput())
        target, lines = BoneDecimatorLogic(slicer.mrmlScene).decimate(node, Request(tolerance=0.1))
        self.assertLess(target.GetPolyData().GetNumberOfPolys(), source.GetOutput().GetNumberOfPolys())
        self.assertTrue(any("proved" in line for line in lines))
