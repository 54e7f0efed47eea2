"""One Zstandard frame (RFC 8878), unpacked by the system's library."""

import ctypes
import ctypes.util

from errors import require

_zstd = ctypes.CDLL(ctypes.util.find_library("zstd") or "libzstd.so.1")
for _name in ("ZSTD_decompress", "ZSTD_findFrameCompressedSize"):
    getattr(_zstd, _name).restype = ctypes.c_size_t
_zstd.ZSTD_isError.argtypes = [ctypes.c_size_t]


def unpack(data, raw_size):
    """3.1: exactly one frame, no dictionary, no skippable frame, nothing before or after it."""
    require(data[:4] == b"\x28\xb5\x2f\xfd", "a packed section does not start with a frame")
    size = _zstd.ZSTD_findFrameCompressedSize(bytes(data), ctypes.c_size_t(len(data)))
    require(not _zstd.ZSTD_isError(size), "a broken frame")
    require(size == len(data), "bytes behind a frame")
    require(_zstd.ZSTD_getDictID_fromFrame(bytes(data), ctypes.c_size_t(len(data))) == 0, "a dictionary")
    content = ctypes.create_string_buffer(max(raw_size, 1))
    got = _zstd.ZSTD_decompress(content, ctypes.c_size_t(raw_size), bytes(data), ctypes.c_size_t(len(data)))
    require(not _zstd.ZSTD_isError(got), "a broken frame, or more than raw_size")
    require(got == raw_size, "a frame with less than raw_size")
    return content.raw[:raw_size]
