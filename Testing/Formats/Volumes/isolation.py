# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of others in processes of their own: some of them end the process on files that they do not understand."""

import os
import pickle
import select
import signal
import struct

from truth import NotRead

LONGEST = 30  # seconds for a file


def _serve(read, files, pipe):
    with os.fdopen(pipe, "wb") as output:
        for path, choice in files:
            try:
                result = read(path, choice)
            except Exception as error:  # of any library
                result = NotRead(f"{type(error).__name__}: {error}"[:200])
            data = pickle.dumps(result)
            output.write(struct.pack("<Q", len(data)) + data)
            output.flush()


def _receive(pipe, count):
    data = b""
    while len(data) < count:
        ready, _, _ = select.select([pipe], [], [], LONGEST)
        part = os.read(pipe, count - len(data)) if ready else b""
        if not part:
            return None
        data += part
    return data


def _read_some(read, files):
    """Results up to the file that ends the process."""
    pipe, into = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(pipe)
            null = os.open(os.devnull, os.O_WRONLY)
            os.dup2(null, 1)
            os.dup2(null, 2)
            _serve(read, files, into)
        finally:
            os._exit(0)
    os.close(into)
    results = []
    while len(results) < len(files):
        size = _receive(pipe, 8)
        data = size and _receive(pipe, struct.unpack("<Q", size)[0])
        if not data:
            break
        results.append(pickle.loads(data))
    os.close(pipe)
    if len(results) < len(files):
        os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return results


def read_all(read, files):
    """@param files (path, choice) of each. @return A Reading or a NotRead for each."""
    results = []
    while len(results) < len(files):
        results += _read_some(read, files[len(results):])
        if len(results) < len(files):
            results.append(NotRead("it ends the process or does not end"))
    return results
