"""libravel by ctypes: the part of ravel/ravel_c.h that this package calls."""

import ctypes
import ctypes.util
import os
import pathlib
from ctypes import POINTER, Structure, byref, c_char, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p

import numpy as np

ABI = 2
NO_INDEX = 2**64 - 1
SCALARS = [np.dtype(name) for name in ("u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8")]
PLACES = ("point", "corner", "cell", "companion", "mesh")
(POSITIONS, CORNERS, CORNER_BEGIN, COMPANION_NODES, COMPANION_HOSTS, ATTRIBUTE_VALUES, ATTRIBUTE_INDEX, STRIP_CELL,
 STRIP_FROM, STRIP_EXIT, STRIP_ENTRY, STRIP_LINK) = range(12)


class RavelError(ValueError):
    """What is wrong with a file or a mesh: `code`, `place` (byte of a file, number of a cell, corner or
    attribute of a mesh) and `sentence`."""

    def __init__(self, code, place, sentence):
        super().__init__(f"{sentence} ({code}, {place})")
        self.code, self.place, self.sentence = code, place, sentence


class Error(Structure):
    _fields_ = [("code", c_int32), ("reserved", c_int32), ("place", c_uint64), ("sentence", c_char * 240)]


class Array(Structure):
    _fields_ = [("count", c_uint64), ("stride", c_uint64), ("arity", c_uint32), ("scalar", c_uint32), ("data", c_void_p)]


class Text(Structure):
    _fields_ = [("text", c_void_p), ("size", c_size_t)]

    def __str__(self):
        return ctypes.string_at(self.text, self.size).decode("utf-8", "surrogateescape") if self.size else ""


class Summary(Structure):
    _fields_ = [("struct_size", c_uint32), ("kind", c_uint32), ("points", c_uint64), ("cells", c_uint64),
                ("corners", c_uint64), ("companion_blocks", c_uint64), ("attributes", c_uint64),
                ("position_scalar", c_uint32), ("exact_positions", c_uint32), ("components", c_uint64), ("links", c_uint64),
                ("keeps_order", c_uint32), ("format_version", c_uint32), ("position_bound", c_double),
                ("position_error", c_double), ("file_bytes", c_uint64)]


class DecodeOptions(Structure):
    _fields_ = [("struct_size", c_uint32), ("strip", c_uint32), ("memory_limit", c_uint64)]


class EncodeOptions(Structure):
    _fields_ = [("struct_size", c_uint32), ("position_bits", c_int32), ("max_error", c_double), ("strip_budget", c_double),
                ("level", c_int32), ("keep_order", c_uint32), ("float32", c_uint32), ("fast", c_uint32),
                ("max_error_relative", c_double), ("lattice", c_double),
                ("attribute_bounds", c_void_p), ("attribute_bound_count", c_uint64),
                ("threads", c_uint32), ("reserved", c_uint32)]


BOUND_KINDS = ("bits", "max_error", "max_error_relative", "octahedral")


class AttributeBound(Structure):
    _fields_ = [("name", c_char_p), ("value", c_double), ("kind", c_uint32), ("reserved", c_uint32)]


class Companion(Structure):
    _fields_ = [("vtk_type", c_uint32), ("nodes_per_cell", c_uint32), ("cells", c_uint64), ("has_hosts", c_uint32),
                ("reserved", c_uint32)]


class Attribute(Structure):
    _fields_ = [("name", Text), ("tuples", c_uint64), ("place", c_uint32), ("scalar", c_uint32), ("arity", c_uint32),
                ("is_pool", c_uint32), ("references", c_uint32), ("reserved", c_uint32)]


class Reference(Structure):
    _fields_ = [("component", c_uint32), ("place", c_uint32), ("base", c_int64)]


class TagName(Structure):
    _fields_ = [("attribute", Text), ("name", Text), ("value", c_int64), ("dimension", c_int32), ("reserved", c_int32)]


class Note(Structure):
    _fields_ = [("key", Text), ("text", Text)]


_E = POINTER(Error)
_A = POINTER(Array)
_SIGNATURES = {
    "ravel_abi": (c_uint32, []),
    "ravel_code_name": (c_char_p, [c_int]),
    "ravel_inspect": (c_int, [c_void_p, c_size_t, POINTER(Summary), _E]),
    "ravel_summary_init": (None, [POINTER(Summary), c_size_t]),
    "ravel_decode_options_init": (None, [POINTER(DecodeOptions), c_size_t]),
    "ravel_decode": (c_int, [c_void_p, c_size_t, POINTER(DecodeOptions), POINTER(c_void_p), _E]),
    "ravel_mesh_free": (None, [c_void_p]),
    "ravel_mesh_summary": (c_int, [c_void_p, POINTER(Summary), _E]),
    "ravel_mesh_array": (c_int, [c_void_p, c_int, c_uint64, _A, _E]),
    "ravel_mesh_companion": (c_int, [c_void_p, c_uint64, POINTER(Companion), _E]),
    "ravel_mesh_attribute": (c_int, [c_void_p, c_uint64, POINTER(Attribute), _E]),
    "ravel_mesh_reference": (c_int, [c_void_p, c_uint64, c_uint32, POINTER(Reference), _E]),
    "ravel_mesh_tag_names": (c_uint64, [c_void_p]),
    "ravel_mesh_tag_name": (c_int, [c_void_p, c_uint64, POINTER(TagName), _E]),
    "ravel_mesh_notes": (c_uint64, [c_void_p]),
    "ravel_mesh_note": (c_int, [c_void_p, c_uint64, POINTER(Note), _E]),
    "ravel_mesh_new": (c_void_p, [c_int]),
    "ravel_mesh_set": (c_int, [c_void_p, c_int, _A, _E]),
    "ravel_mesh_add_companion": (c_int, [c_void_p, c_uint32, _A, _A, _E]),
    "ravel_mesh_add_attribute": (c_int, [c_void_p, c_char_p, c_int, _A, _A, _E]),
    "ravel_mesh_add_tag_name": (c_int, [c_void_p, c_char_p, c_int32, c_int64, c_char_p, _E]),
    "ravel_mesh_add_note": (c_int, [c_void_p, c_char_p, c_char_p, _E]),
    "ravel_encode_options_init": (None, [POINTER(EncodeOptions), c_size_t]),
    "ravel_encode": (c_int, [c_void_p, POINTER(EncodeOptions), POINTER(c_void_p), _E]),
    "ravel_packed_free": (None, [c_void_p]),
    "ravel_packed_array": (c_int, [c_void_p, c_int, _A, _E]),
    "ravel_packed_bound": (c_double, [c_void_p]),
    "ravel_packed_error": (c_double, [c_void_p]),
}
_loaded = None


def _candidates():
    if "RAVEL_LIBRARY" in os.environ:
        yield os.environ["RAVEL_LIBRARY"]
        return
    here = pathlib.Path(__file__).resolve().parent
    yield from sorted(map(str, here.glob("libravel.so*")))
    found = ctypes.util.find_library("ravel")
    if found:
        yield found


def library():
    """libravel, loaded once: the file that RAVEL_LIBRARY names, one beside this package, or the system's."""
    global _loaded
    if _loaded is None:
        tried = []
        for path in _candidates():
            try:
                found = ctypes.CDLL(path)
                for name, (result, arguments) in _SIGNATURES.items():
                    function = getattr(found, name)
                    function.restype, function.argtypes = result, arguments
            except (OSError, AttributeError) as error:
                tried.append(f"{path}: {error}")
                continue
            if found.ravel_abi() != ABI:
                tried.append(f"{path}: its interface has version {found.ravel_abi()}, not {ABI}")
                continue
            _loaded = found
            break
        else:
            raise ImportError("libravel.so is missing: build it with -DBUILD_SHARED_LIBS=ON and install it, or let "
                              "RAVEL_LIBRARY name it" + "".join(f"\n  tried {line}" for line in tried))
    return _loaded


def call(name, *arguments):
    """Calls a function that can fail; its last argument, the error, is ours."""
    error = Error()
    code = getattr(library(), name)(*arguments, byref(error))
    if code != 0:
        spelled = library().ravel_code_name(code).decode()
        raise RavelError(spelled, error.place, error.sentence.decode("utf-8", "replace"))


def copy_of(view):
    """A view of the library as a NumPy array of its own, (count,) or (count, arity)."""
    scalar = SCALARS[view.scalar]
    shape = (view.count,) if view.arity == 1 else (view.count, view.arity)
    if view.count == 0 or view.arity == 0:
        return np.empty(shape, scalar)
    size = (view.count - 1) * view.stride + view.arity * scalar.itemsize
    buffer = (c_char * size).from_address(view.data)
    strides = (view.stride,) if view.arity == 1 else (view.stride, scalar.itemsize)
    return np.ndarray(shape, scalar, buffer, strides=strides).copy()


def view_of(array):
    """A NumPy array as the library sees it, and what must stay alive meanwhile."""
    array = np.ascontiguousarray(array)
    if array.dtype.newbyteorder("=") not in SCALARS:
        raise TypeError(f"arrays of {array.dtype} can't be stored; integers and floats of 32 or 64 bits can")
    array = array.astype(array.dtype.newbyteorder("="), copy=False)
    rows = array.reshape(len(array), -1) if array.size else array.reshape(len(array), int(np.prod(array.shape[1:], initial=1)))
    scalar = SCALARS.index(rows.dtype)
    return Array(len(rows), rows.shape[1] * rows.itemsize, rows.shape[1], scalar, rows.ctypes.data), rows
