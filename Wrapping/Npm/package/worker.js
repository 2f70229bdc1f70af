// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The worker of browsers.
import { runJob } from './job.js';

self.onmessage = ({ data }) => runJob(data, (message, transfer) => self.postMessage(message, transfer));
