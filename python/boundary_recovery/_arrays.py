"""Arrays as the compiled half takes them: what has its type already is not copied."""
from typing import Any, Optional

import numpy as np


def as_points(points: Any) -> np.ndarray:
    array = np.asarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError("points: an array of shape (n, 3) is needed, not %s" % (array.shape,))
    return array


def as_indices(indices: Any, width: int, name: str) -> np.ndarray:
    if indices is None:
        return np.empty((0, width), dtype=np.int64)
    array = np.asarray(indices)
    if array.size == 0:
        return np.empty((0, width), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError("%s: an array of shape (m, %d) is needed, not %s" % (name, width, array.shape))
    if array.dtype.kind not in "iu":
        raise TypeError("%s: integers are needed, not %s" % (name, array.dtype))
    return array if array.itemsize in (4, 8) and array.dtype.isnative else array.astype(np.int64)


def as_numbers(numbers: Any, dtype: Any, size: int, name: str) -> np.ndarray:
    """One number each: contiguous."""
    array = np.ascontiguousarray(numbers, dtype=dtype)
    if array.shape != (size,):
        raise ValueError("%s: an array of shape (%d,) is needed, not %s" % (name, size, array.shape))
    return array


def as_numbers_or_none(numbers: Any, dtype: Any, size: int, name: str) -> Optional[np.ndarray]:
    return None if numbers is None else as_numbers(numbers, dtype, size, name)
