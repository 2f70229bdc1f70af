// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The worker of Node.js.
import { parentPort } from 'node:worker_threads';
import { runJob } from './job.js';

parentPort.on('message', (data) => runJob(data, (message, transfer) => parentPort.postMessage(message, transfer)));
