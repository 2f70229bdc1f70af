# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A progress bar by tqdm or rich, whichever is there."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import contextmanager

Progress = Callable[[float], object]


class Aborted(RuntimeError):
    """The progress function returned False, and there is no result without the whole run."""


@contextmanager
def listener(progress: bool | Progress | None):
    """What the core calls with the fraction done: the function given, that of a bar for True, or None."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _bar() as move:
            yield move
    elif callable(progress):
        yield progress
    else:
        raise TypeError(f"progress is True, False or a function of the fraction done, not {progress!r}")


def _bar():
    try:
        import tqdm.auto  # noqa: F401
        return _tqdm_bar()
    except ImportError:
        pass
    try:
        import rich.progress  # noqa: F401
        return _rich_bar()
    except ImportError:
        raise ImportError("a progress bar needs tqdm or rich: pip install tqdm") from None


@contextmanager
def _tqdm_bar():
    from tqdm.auto import tqdm
    with tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}") as bar:
        def move(fraction: float) -> None:
            bar.update(100 * fraction - bar.n)
        yield move


@contextmanager
def _rich_bar():
    from rich.progress import Progress as Bars
    with Bars() as bars:
        task = bars.add_task("bonedecimate", total=1.0)

        def move(fraction: float) -> None:
            bars.update(task, completed=fraction)
        yield move
