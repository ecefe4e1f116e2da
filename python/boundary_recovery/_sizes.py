"""Sizes: the lengths that edges inside are to have."""
import os
from dataclasses import dataclass
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import as_indices, as_numbers, as_points

Size = Union[None, float, np.ndarray, Callable[[np.ndarray], Any]]
Path = Union[str, "os.PathLike[str]"]
Background = Union[None, Path, Tuple[Any, Any, Any]]


@dataclass(frozen=True)
class Source:
    """A place around which edges are short: a point, a segment, a triangle, or a box with sides parallel to the axes.

    points    one point, or the ends of a segment, or the corners of a triangle, or two opposite corners of a box
    size      the size within `radius` of it
    radius    a distance, that from the nearest point of the source
    grading   by how much the size grows per length beyond `radius`
    doubling  if it is given, the distance where the size has doubled; it doubles again with each further length of
              `doubling - radius`. Then `grading` has no meaning.
    box       whether two points are corners of a box
    """
    points: Any
    size: float
    radius: float = 0.0
    grading: float = 0.2
    doubling: Optional[float] = None
    box: bool = False

    def __post_init__(self) -> None:
        points = np.atleast_2d(np.asarray(self.points, dtype=np.float64))
        if points.ndim != 2 or points.shape[1] != 3 or not 1 <= len(points) <= 3 or (self.box and len(points) != 2):
            raise ValueError("points: an array of 1 to 3 points is needed, for a box of 2")
        object.__setattr__(self, "points", points)

    @property
    def _shape(self) -> int:
        return 4 if self.box else len(self.points)


def size_arguments(size: Size, number_of_points: int, grading: float, sources: Union[Path, Sequence[Source]],
                   background: Background) -> Dict[str, Any]:
    """What the compiled half wants to know of sizes."""
    grading = float(grading)
    if not grading >= 0:
        raise ValueError("grading: a number is needed that is not negative")
    arguments: Dict[str, Any] = {"grading": grading}
    if size is None or (isinstance(size, np.ndarray) and size.ndim > 0) or isinstance(size, (list, tuple)):
        if grading == np.inf:
            raise ValueError("grading: sizes from points or a surface need a finite one")
    if size is None:
        arguments["is_from_surface"] = True
    elif callable(size):
        arguments["function"] = size
    elif np.ndim(size) == 0:
        arguments["uniform"] = float(size)
        if not 0 < arguments["uniform"] < np.inf:
            raise ValueError("size: a positive number is needed")
    else:
        arguments["at_points"] = as_numbers(size, np.float64, number_of_points, "size")
    if isinstance(sources, (str, os.PathLike)):
        arguments["source_file"] = os.fspath(sources)
        with open(arguments["source_file"], "rb"):
            pass  # raises what says why it cannot be read
    elif len(sources) > 0:
        arguments["sources"] = list(sources)
    if isinstance(background, (str, os.PathLike)):
        arguments["background_file"] = os.fspath(background)
    elif background is not None:
        points, tetrahedra, sizes = background
        arguments["background_points"] = as_points(points)
        arguments["background_tetrahedra"] = as_indices(tetrahedra, 4, "background")
        arguments["background_sizes"] = as_numbers(sizes, np.float64, len(arguments["background_points"]), "background")
    return arguments
