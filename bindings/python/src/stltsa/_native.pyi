# The extension that cffi builds from stltsa.h, which describes its contents.
from typing import Any

ffi: Any
lib: Any
