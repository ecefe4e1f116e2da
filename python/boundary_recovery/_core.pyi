from typing import Any, Callable, Dict, Optional

import numpy as np

version: str

def tetrahedralize(points: np.ndarray, triangles: np.ndarray, edges: np.ndarray, size: Dict[str, Any],
                   options: Dict[str, Any], progress: Optional[Callable[[str, float], Any]]) -> Dict[str, Any]: ...
def improve(points: np.ndarray, tetrahedra: np.ndarray, regions: Optional[np.ndarray], facets: np.ndarray,
            edges: np.ndarray, options: Dict[str, Any],
            progress: Optional[Callable[[str, float], Any]]) -> Dict[str, Any]: ...
def remesh_holes(points: np.ndarray, tetrahedra: np.ndarray, regions: Optional[np.ndarray],
                 selected: Optional[np.ndarray], facets: np.ndarray, edges: np.ndarray,
                 size: Optional[Dict[str, Any]], options: Dict[str, Any],
                 progress: Optional[Callable[[str, float], Any]]) -> Dict[str, Any]: ...
def read_surface(file: str) -> Dict[str, Any]: ...
def repair_surface(points: np.ndarray, triangles: np.ndarray, tolerance: float) -> Dict[str, Any]: ...
