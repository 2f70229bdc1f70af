# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panel. BoneDecimatorLib has its logic, which needs no window."""

import json

import ctk
import qt
import slicer
import vtk
from BoneDecimatorLib.checks import AUTOMATIC
from BoneDecimatorLib.compare_widgets import CompareWidgets, with_progress
from BoneDecimatorLib.engines import Canceled, DecimationError, NoEngine
from BoneDecimatorLib.logic import CAPS, NO_SMOOTHING, OWN_DISTANCE, SMOOTHINGS, BoneDecimatorLogic, presets, smoothing_of, spacing_of
from BoneDecimatorLib.option_table import SEGMENT_RUNS
from BoneDecimatorLib.option_widgets import OptionWidgets, number_box
from BoneDecimatorLib.package_widgets import PackageWidgets
from BoneDecimatorLib.preview import Preview
from BoneDecimatorLib.request import Request
from BoneDecimatorLib.segmentation import has_label_map
from BoneDecimatorLib.surfaces import DISTANCE, report_of
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleTest, ScriptedLoadableModuleWidget

MODELS, CLOSED_SURFACES = "models in a folder", "closed surfaces of the segmentation"
EVERYWHERE, ONLY_THERE, KEEP = "everywhere", "only where the brush is", "everywhere but there"


class BoneDecimator(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Bone Decimator"
        parent.categories = ["Surface Models"]
        parent.contributors = ["vtkBoneDecimate contributors"]
        parent.helpText = ("Makes surfaces of bone smaller and proves, in mm, how far the results are from them. The segments of a "
                           "segmentation are extracted with walls in common, smoothed and simplified together, and every voxel "
                           "can keep its segment. Not a medical device.")
        parent.acknowledgementText = "After H. Brandao's thesis on normal field deviation, 2018."


class BoneDecimatorWidget(ScriptedLoadableModuleWidget):
    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = BoneDecimatorLogic(slicer.mrmlScene)
        self.levels = None
        self.results = []  # model nodes of the last run
        self._addSource()
        self._addFirst()
        self._addActions()
        self._addBrush()
        self._addSmoothing()
        self._addOptions()
        self._addCaps()
        self.compare = CompareWidgets(self._section("Compare two models", collapsed=True), self._nodes, self._millimeters,
                                      lambda: self._try(self._onCompare))
        self._addPreview()
        self.package = PackageWidgets(self._section("Python package", collapsed=True), self._try, self._onInstalled)
        self._fillOptions()
        self.layout.addStretch(1)

    def cleanup(self):
        self.live.checked = False
        self.logic.release_memory()

    def exit(self):
        self.live.checked = False

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
        return number_box(value, 0.0, largest, " mm")

    def _addSource(self):
        form = self._section("Bone")
        self.source = self._nodes(["vtkMRMLModelNode", "vtkMRMLSegmentationNode"])
        self.segments = slicer.qMRMLSegmentsTableView()
        self.segments.setMRMLScene(slicer.mrmlScene)
        self.segments.toolTip = "The selected segments; if none is selected, those that are visible."
        self.volume = self._nodes(["vtkMRMLScalarVolumeNode"])
        self.target = self._nodes(["vtkMRMLModelNode"], may_be_new=True)
        self.kind = qt.QComboBox()
        self.kind.addItems([MODELS, CLOSED_SURFACES])
        self.kind.toolTip = "Slicer makes closed surfaces again, with its own smoothing, when the voxels change."
        self.source.currentNodeChanged.connect(self._onSource)
        form.addRow("Model or segmentation", self.source)
        form.addRow("Segments", self.segments)
        form.addRow("Scan, for presets of a model", self.volume)
        form.addRow("Result of a model (none: a new model)", self.target)
        form.addRow("Result of segments", self.kind)

    def _onSource(self, node):
        is_segmentation = node is not None and node.IsA("vtkMRMLSegmentationNode")
        self.segments.visible = is_segmentation
        self.segments.setSegmentationNode(node if is_segmentation else None)
        self.kind.enabled = self.modelGrid.enabled = has_label_map(node)
        self.target.enabled = not has_label_map(node)
        self.levels = None
        self.logic.release_memory()

    def _chosenSegments(self):
        """Their IDs; None: those that are visible."""
        node = self.source.currentNode()
        if node is None or not node.IsA("vtkMRMLSegmentationNode"):
            return None
        return list(self.segments.selectedSegmentIDs()) or None

    def _addFirst(self):
        """What most people set; all else is in sections below."""
        form = self.first = self._section("Simplify")
        self.mode, self.keepVoxels = qt.QComboBox(), qt.QComboBox()  # choices: _fillOptions()
        self.tolerance = self._millimeters(0.2, 100.0)
        self.tolerance.toolTip = ("No point of either surface is farther from the other, smoothing included: proved. 0: no limit; "
                                  "smoothing alone keeps all triangles.")
        buttons = qt.QHBoxLayout()
        for name in presets((1.0,)):
            button = qt.QPushButton(name)
            button.clicked.connect(lambda _checked=False, name=name: self._try(lambda: self._onPreset(name)))
            buttons.addWidget(button)
        self.triangles = qt.QSpinBox()
        self.triangles.maximum, self.triangles.singleStep = 100_000_000, 1000
        self.triangles.specialValueText = "as few as the tolerance allows"
        self.smoothing = qt.QComboBox()
        self.smoothing.addItems(SMOOTHINGS)
        self.smoothing.toolTip = ("Removes the steps of the voxels first. No point moves farther than this, nor than the tolerance. "
                                  "Automatic: a third of the tolerance, or half a voxel. Surfaces of gray values need none.")
        self.keepVoxels.toolTip = ("On: voxelized again, every voxel is in the segment it was in. Auto: on up to a tolerance of half "
                                   "a voxel, where it costs few triangles. For segments.")
        self.where = qt.QComboBox()
        self.where.addItems([EVERYWHERE, ONLY_THERE, KEEP])
        for label, widget in (("Mode", self.mode), ("Tolerance", self.tolerance), ("", buttons), ("Triangles", self.triangles),
                              ("Smoothing", self.smoothing), ("Keep voxels", self.keepVoxels), ("Where", self.where)):
            form.addRow(label, widget)

    def _addSmoothing(self):
        form = self._section("Voxels and smoothing", collapsed=True)
        self.modelGrid = qt.QComboBox()
        self.modelGrid.editable = True
        self.modelGrid.addItems(["auto", "off"])
        self.modelGrid.toolTip = ("Segments that a network made on a coarser grid are extracted and smoothed there. auto: where that is "
                                  "certain; off: never; or the spacing of the network in mm, one number or three with commas.")
        self.ownSmoothing = self._millimeters(0.2, 100.0)
        self.ownSmoothing.enabled = False
        self.smoothing.currentTextChanged.connect(lambda text: setattr(self.ownSmoothing, "enabled", text == OWN_DISTANCE))
        self.featureAngle = qt.QDoubleSpinBox()
        self.featureAngle.maximum, self.featureAngle.value, self.featureAngle.suffix = 180.0, 180.0, " degrees"
        self.featureAngle.toolTip = ("Edges of cuts, implants and fractures stay sharp if the normals beside them differ by more than "
                                     "this: 45 is a good value. 180: none.")
        form.addRow("Grid of the network", self.modelGrid)
        form.addRow("Own distance", self.ownSmoothing)
        form.addRow("Keep edges sharper than", self.featureAngle)
        self._onSource(None)

    def _onPreset(self, name):
        self.tolerance.value = presets(spacing_of(self.source.currentNode(), self.volume.currentNode()))[name]

    def _addOptions(self):
        self.table = None  # of the engine
        self.options = OptionWidgets(self.first, lambda title: self._section(title, collapsed=True))

    def _fillOptions(self):
        """Takes choices and options from the engine's table, as soon as there is one."""
        try:
            self.table = self.logic.engine.table
        except DecimationError as problem:
            self.options.explain(str(problem))
            self.package.tell(None)
            return
        self.package.tell(self.logic.engine)
        if self.options.of_flag:  # filled by the engine before
            return
        rows = self.table.rows
        for box, choices, name in ((self.mode, self.table.modes, "Mode"), (self.keepVoxels, rows["KeepVoxels"]["choices"], "KeepVoxels")):
            box.addItems(choices)
            box.currentText = rows[name]["default"]
        self.options.fill(self.table, self._onChange)
        self._enableOptions()

    def _enableOptions(self):
        smoothing = self.smoothing.currentText
        values = {"mode": self.mode.currentText, "keep-voxels": self.keepVoxels.currentText, "max-error": self.tolerance.value,
                  "target-triangles": self.triangles.value, "auto-smooth": smoothing == AUTOMATIC,
                  "smooth": float(smoothing not in (NO_SMOOTHING, AUTOMATIC))}
        self.options.enable(self.table, values, SEGMENT_RUNS if has_label_map(self.source.currentNode()) else ())

    def _onChange(self, *_values):
        if self.table is not None:
            self._enableOptions()
        self.preview.changed()

    def _addBrush(self):
        form = self._section("Brush", collapsed=True)
        self.brush = self._nodes(["vtkMRMLMarkupsFiducialNode", "vtkMRMLMarkupsROINode"], may_be_new=True)
        self.paint = qt.QLineEdit()
        self.paint.placeholderText = "or a painted point array (Dynamic Modeler, Select by points)"
        self.radius, self.feather = self._millimeters(10.0, 1000.0), self._millimeters(2.0, 100.0)
        for label, widget in (("Points or region of interest", self.brush), ("Point array", self.paint),
                              ("Radius of a point", self.radius), ("Feather", self.feather)):
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

    def _addCaps(self):
        form = self._section("Open boundaries", collapsed=True)
        self.caps = qt.QComboBox()
        self.caps.addItems(CAPS)
        self.caps.toolTip = ("Closes a model for volume meshers and solvers. A cap is bone where the scan shows none: close the model "
                             "first and simplify the closed one, so that the tolerance includes the caps.")
        button = qt.QPushButton("Close into a new model")
        button.clicked.connect(lambda _checked=False: self._try(self._onCap))
        form.addRow("Close", self.caps)
        form.addRow(button)

    def _addPreview(self):
        form = self._section("Live preview")
        self.live = qt.QCheckBox("Show the result while values change")
        self.live.toolTip = "Of a large bone a part is shown. Distances are not proved in a preview."
        self.live.toggled.connect(self._onLive)
        self.previewText = qt.QLabel()
        self.previewText.wordWrap = True
        self.preview = Preview(self._runPreview, lambda text: setattr(self.previewText, "text", text), slicer.app.processEvents)
        self.timer = qt.QTimer()
        self.timer.interval = 100
        self.timer.timeout.connect(self.preview.tick)
        form.addRow(self.live)
        form.addRow(self.previewText)
        for signal in (self.source.currentNodeChanged, self.segments.selectionChanged, self.smoothing.currentTextChanged,
                       self.ownSmoothing.valueChanged, self.featureAngle.valueChanged, self.tolerance.valueChanged, self.triangles.valueChanged,
                       self.mode.currentTextChanged, self.keepVoxels.currentTextChanged, self.modelGrid.currentTextChanged, self.where.currentTextChanged,
                       self.brush.currentNodeChanged, self.paint.textChanged, self.radius.valueChanged, self.feather.valueChanged):
            signal.connect(self._onChange)

    def _onLive(self, on):
        self.previewText.text = ""
        if on:
            self.preview.start()
            self.timer.start()
        else:
            self.timer.stop()
            self.preview.stop()
            self.logic.remove_preview()

    def _runPreview(self, progress):
        lines = self.logic.preview(self.source.currentNode(), self.request(), self._chosenSegments(), progress=progress)
        self.previewText.text = "\n".join(lines)

    # --- what the buttons do

    def request(self):
        where, brush = self.where.currentText, None
        if where != EVERYWHERE:
            brush = self.paint.text.strip() or self.brush.currentNode()
            if not brush:
                raise DecimationError("Choose points, a region of interest or a point array under 'Brush'.")
        choice = self.smoothing.currentText
        needs_spacing = choice not in (NO_SMOOTHING, AUTOMATIC, OWN_DISTANCE)
        spacing = spacing_of(self.source.currentNode(), self.volume.currentNode()) if needs_spacing else None
        return Request(tolerance=self.tolerance.value, triangles=self.triangles.value, mode=self.mode.currentText or None,
                       smoothing=smoothing_of(choice, spacing, self.ownSmoothing.value),
                       feature_angle=self.featureAngle.value, keep_voxels=self.keepVoxels.currentText or None,
                       model_grid=self.modelGrid.currentText.strip() or "auto",
                       extra=self.options.values(only_enabled=True), brush=brush, keeps_brush=where == KEEP,
                       radius=self.radius.value, feather=self.feather.value)

    def _try(self, action):
        try:
            action()
        except Canceled:
            self.text.text = "Canceled; nothing has changed."
        except DecimationError as problem:
            if isinstance(problem, NoEngine):
                self.package.expand()
            slicer.util.errorDisplay(str(problem))

    def _onInstalled(self):
        self.logic.renew_engine()
        self._fillOptions()

    def _onSimplify(self):
        self.live.checked = False
        self.text.text = "\n".join(with_progress("Simplifying", self._simplify))

    def _simplify(self, tell):
        source, segments = self.source.currentNode(), self._chosenSegments()
        if has_label_map(source):
            as_models = self.kind.currentText == MODELS
            nodes, lines = self.logic.decimate_segments(source, self.request(), segments, as_models, tell)
            self.results = nodes if as_models else []
            return lines
        segment = segments[0] if segments and len(segments) == 1 else None
        node, lines = self.logic.decimate(source, self.request(), self.target.currentNode(), segment, tell)
        node.CreateDefaultDisplayNodes()
        self.target.setCurrentNode(node)
        self.results = [node]
        return lines

    def _onCap(self):
        segment = (self._chosenSegments() or [None])[0]
        node, lines = self.logic.cap(self.source.currentNode(), self.caps.currentText, None, segment)
        node.CreateDefaultDisplayNodes()
        self.results = [node]
        self.source.setCurrentNode(node)  # what is simplified next
        self.text.text = "\n".join(lines)

    def _onCompare(self):
        nodes = with_progress("Proving the distance", lambda tell: self.compare.run(self.logic, tell))
        if nodes:
            self._showDistances(nodes, "distance to the other model, mm")

    def _onUndo(self):
        if self.logic.can_undo():
            node = self.logic.undo()
            self.results = [node] if node is not None else []
            self.target.setCurrentNode(node)
            self.text.text = ""

    def _onToggle(self):
        before = self.source.currentNode()
        after = [node for node in self.results if node.GetDisplayNode()]
        if before and after and before.GetDisplayNode():
            shown = after[0].GetDisplayNode().GetVisibility()
            for node in after:
                node.GetDisplayNode().SetVisibility(not shown)
            before.GetDisplayNode().SetVisibility(shown)

    def _onHeatMap(self):
        nodes = [node for node in self.results if node.GetPolyData().GetPointData().GetArray(DISTANCE) is not None]
        if not nodes:
            raise DecimationError("Simplify first: there is no distance to show.")
        self._showDistances(nodes, "distance to the original, mm")

    def _showDistances(self, nodes, title):
        for node in nodes:
            node.CreateDefaultDisplayNodes()
            display = node.GetDisplayNode()
            display.SetActiveScalar(DISTANCE, vtk.vtkAssignAttribute.POINT_DATA)
            display.SetAndObserveColorNodeID("vtkMRMLColorTableNodeFileViridis.txt")
            display.SetScalarVisibility(True)
        legend = slicer.modules.colors.logic().AddDefaultColorLegendDisplayNode(nodes[0])
        legend.SetTitleText(title)

    def _onLevel(self, percent):
        source, target = self.source.currentNode(), self.target.currentNode()
        if source is None or target is None or target is source:
            return
        if self.levels is None:
            with slicer.util.WaitCursor():
                self.levels = self.logic.record_levels(source, segment=(self._chosenSegments() or [None])[0])
        self.logic.show_level(self.levels, int(percent / 100.0 * self.levels.result.report["input.triangles"]), target)
        self.text.text = f"{target.GetPolyData().GetNumberOfPolys():,} triangles"

    def _onReport(self):
        found = report_of(self.results[0].GetPolyData()) if self.results else {}
        if not found:
            raise DecimationError("Simplify a model, or segments into models, first: there is no report.")
        path = qt.QFileDialog.getSaveFileName(None, "Save report", "report.json", "JSON (*.json)")
        if path:
            with open(path, "w", encoding="utf-8") as file:
                file.write(json.dumps(found, indent=2) + "\n")


class BoneDecimatorTest(ScriptedLoadableModuleTest):
    def runTest(self):
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
