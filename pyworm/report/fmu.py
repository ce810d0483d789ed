"""A loss table as a functional mock-up unit: FMI 3.0, co-simulation, C source and its compiled library.

Standard: Modelica Association, Functional Mock-up Interface 3.0 (2022), fmi-standard.org.
"""

import os
import platform
import re
import shutil
import subprocess
import sys
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from uuid import NAMESPACE_URL, uuid5
from xml.etree import ElementTree
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np

from pyworm.io.atomic import whole_file
from pyworm.result.loss_table import LossTable

SOURCE = Path(__file__).with_name("loss_table.c")
"""The unit but for its table."""

COMPILER_FLAGS = ("-std=c11", "-O2", "-shared", "-fPIC", "-fvisibility=hidden")

COMPILE_SECONDS = 120
"""Time after which a compiler is given up [s]."""

INPUTS = (
    ("speed", "rad/s", "Speed of the worm; with torque against it the wheel drives"),
    ("torque", "N.m", "Torque on the worm"),
    ("temperature", "K", "Temperature of the oil at the inlet"),
)
OUTPUTS = (
    ("efficiency", "1", "Efficiency of the teeth with the worm driving"),
    (
        "reverse_efficiency",
        "1",
        "Efficiency of the teeth with the wheel driving; not positive if locked",
    ),
    ("friction_torque", "N.m", "Friction torque on the worm: teeth, bearings, seals and churning"),
    ("output_torque", "N.m", "Torque that the wheel gives"),
    ("transmission_error", "rad", "Mean loaded transmission error, turn of the wheel"),
    ("mesh_stiffness", "N.m/rad", "Mean mesh stiffness about the axis of the wheel"),
)
FLAGS = (
    ("locked", "Whether the wheel cannot drive the worm"),
    ("outside", "Whether an input lies outside the table, whose end then holds"),
)
"""Variables in the order of their references, from 1; 0 is the time."""

UNITS = {
    "rad/s": {"rad": 1, "s": -1},
    "N.m": {"kg": 1, "m": 2, "s": -2},
    "K": {"K": 1},
    "1": {},
    "rad": {"rad": 1},
    "N.m/rad": {"kg": 1, "m": 2, "s": -2, "rad": -1},
}
"""Unit -> exponents of its base units."""

UNSUPPORTED = (
    *("EnterEventMode", "EnterConfigurationMode", "ExitConfigurationMode", "EnterStepMode"),
    *(
        f"{access}{kind}"
        for kind in ("Float32", "String", "Binary", "Clock")
        for access in ("Get", "Set")
    ),
    *(
        f"{access}{sign}Int{bits}"
        for access in ("Get", "Set")
        for sign in ("", "U")
        for bits in (8, 16, 32, 64)
    ),
    *("SetBoolean", "GetNumberOfVariableDependencies", "GetVariableDependencies"),
    *("GetFMUState", "SetFMUState", "FreeFMUState", "SerializedFMUStateSize", "SerializeFMUState"),
    *("DeserializeFMUState", "GetDirectionalDerivative", "GetAdjointDerivative"),
    *("GetIntervalDecimal", "GetIntervalFraction", "GetShiftDecimal", "GetShiftFraction"),
    *("SetIntervalDecimal", "SetIntervalFraction", "SetShiftDecimal", "SetShiftFraction"),
    *("EvaluateDiscreteStates", "UpdateDiscreteStates", "EnterContinuousTimeMode"),
    *("CompletedIntegratorStep", "SetTime", "SetContinuousStates", "GetContinuousStateDerivatives"),
    *("GetEventIndicators", "GetContinuousStates", "GetNominalsOfContinuousStates"),
    *("GetNumberOfEventIndicators", "GetNumberOfContinuousStates", "GetOutputDerivatives"),
    "ActivateModelPartition",
)
"""Functions of the standard that return an error, as the description allows none of them."""

SYSTEMS = {"linux": ("linux", ".so"), "darwin": ("darwin", ".dylib")}
"""`sys.platform` -> system in the name of a platform, ending of a library."""

MACHINES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}
"""`platform.machine` -> processor in the name of a platform."""


class NoCompilerError(RuntimeError):
    """The library of a unit could not be compiled; the message says why."""


def identifier(name: str) -> str:
    """A name as an identifier of C and Modelica."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)
    return plain if re.match(r"[A-Za-z]", plain) else f"gear_{plain}"


def c_source(table: LossTable) -> str:
    """The C source of the unit of a table."""
    source = SOURCE.read_text(encoding="utf-8").replace("@NAME@", identifier(table.name))
    stubs = "\n".join(f"CANNOT({name})" for name in UNSUPPORTED)
    return source.replace("@UNSUPPORTED@", stubs).replace("@TABLE@", _arrays(table))


def _token(table: LossTable) -> str:
    """Token of a table's content, which ties library and description."""
    digest = sha256(_numbers(table).encode()).hexdigest()
    return f"{{{uuid5(NAMESPACE_URL, digest)}}}"


def _arrays(table: LossTable) -> str:
    return f'#define TOKEN "{_token(table)}"\n{_numbers(table)}'


def _numbers(table: LossTable) -> str:
    """The numbers of a table as constants of C."""
    shape = table.efficiency.shape
    by_torque = (
        np.broadcast_to(row[None, :, None], shape)
        for row in (table.transmission_error, table.stiffness)
    )
    errors, stiffnesses = by_torque
    arrays = {
        "speeds": table.speeds,
        "torques": table.torques,
        "temperatures": table.temperatures,
        "efficiencies": table.efficiency,
        "reverse_efficiencies": table.reverse_efficiency,
        "other_torque": table.other_torque,
        "transmission_errors": errors,
        "stiffnesses": stiffnesses,
    }
    counts = zip(("SPEEDS", "TORQUES", "TEMPERATURES"), shape, strict=True)
    lines = [f"#define {name} {count}" for name, count in counts]
    lines.append(f"#define RATIO {table.ratio!r}")
    for name, values in arrays.items():
        numbers = ", ".join(repr(float(value)) for value in np.ravel(values))
        lines.append(f"static const double {name}[] = {{{numbers}}};")
    return "\n".join(lines)


def description(table: LossTable) -> bytes:
    """`modelDescription.xml` of the unit of a table."""
    name = identifier(table.name)
    root = ElementTree.Element(
        "fmiModelDescription",
        fmiVersion="3.0",
        modelName=name,
        instantiationToken=_token(table),
        description=table.title,
        generationTool="pyworm",
    )
    ElementTree.SubElement(
        root, "CoSimulation", modelIdentifier=name, canHandleVariableCommunicationStepSize="true"
    )
    units = ElementTree.SubElement(root, "UnitDefinitions")
    for unit, powers in UNITS.items():
        written = {base: str(power) for base, power in powers.items()}
        ElementTree.SubElement(
            ElementTree.SubElement(units, "Unit", name=unit), "BaseUnit", written
        )
    _add_variables(root, table)
    structure = ElementTree.SubElement(root, "ModelStructure")
    inputs = " ".join(str(number) for number in range(1, len(INPUTS) + 1))
    references = range(1 + len(INPUTS), 1 + len(INPUTS) + len(OUTPUTS) + len(FLAGS))
    for kind in ("Output", "InitialUnknown"):
        for reference in references:
            ElementTree.SubElement(
                structure, kind, valueReference=str(reference), dependencies=inputs
            )
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)
    return text


def _add_variables(root: ElementTree.Element, table: LossTable) -> None:
    """Add the variables, with the first point of the table as their start."""
    variables = ElementTree.SubElement(root, "ModelVariables")
    time = {
        "name": "time",
        "valueReference": "0",
        "causality": "independent",
        "variability": "continuous",
    }
    ElementTree.SubElement(variables, "Float64", time)
    starts = table.speeds[0], table.torques[0] / table.ratio, table.temperatures[0]
    reference = 0
    for (name, unit, words), start in zip(INPUTS, starts, strict=True):
        reference += 1
        about = {"name": name, "valueReference": str(reference), "causality": "input", "unit": unit}
        about |= {"description": words, "start": repr(float(start)), "variability": "continuous"}
        ElementTree.SubElement(variables, "Float64", about)
    for name, unit, words in OUTPUTS:
        reference += 1
        about = {
            "name": name,
            "valueReference": str(reference),
            "causality": "output",
            "unit": unit,
        }
        ElementTree.SubElement(variables, "Float64", about | {"description": words})
    for name, words in FLAGS:
        reference += 1
        about = {"name": name, "valueReference": str(reference), "causality": "output"}
        ElementTree.SubElement(variables, "Boolean", about | {"description": words})


def _build_description(table: LossTable) -> bytes:
    """`sources/buildDescription.xml`, by which importers compile the source themselves."""
    name = identifier(table.name)
    root = ElementTree.Element("fmiBuildDescription", fmiVersion="3.0")
    build = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=name)
    files = ElementTree.SubElement(build, "SourceFileSet", language="C11")
    ElementTree.SubElement(files, "SourceFile", name=f"{name}.c")
    text: bytes = ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)
    return text


def compiled(source: str) -> tuple[str, bytes]:
    """The library of a source by the system's C compiler, and its place in a unit but for its name.

    NoCompilerError where there is none, it fails, or the platform has no name in the standard.
    """
    command = os.environ.get("CC", "cc").split()
    machine = MACHINES.get(platform.machine().lower())
    system, ending = SYSTEMS.get(sys.platform, ("", ""))
    if not machine or not system:
        raise NoCompilerError(f"libraries for {sys.platform} are not built here")
    if shutil.which(command[0]) is None:
        raise NoCompilerError(f"there is no C compiler {command[0]}")
    with TemporaryDirectory() as folder:
        file, library = Path(folder, "unit.c"), Path(folder, "unit")
        file.write_text(source, encoding="utf-8")
        words = [*command, *COMPILER_FLAGS, str(file), "-o", str(library), "-lm"]
        try:
            run = subprocess.run(
                words, capture_output=True, text=True, timeout=COMPILE_SECONDS, check=False
            )
        except subprocess.TimeoutExpired:
            raise NoCompilerError(f"{command[0]} took longer than {COMPILE_SECONDS} s") from None
        if run.returncode:
            first = (run.stderr.strip() or "without a message").splitlines()[0]
            raise NoCompilerError(f"{command[0]} failed: {first}")
        return f"binaries/{machine}-{system}/{{}}{ending}", library.read_bytes()


def write_fmu(table: LossTable, path: Path) -> str | None:
    """Write the unit of a table; returns why it has no library, None where it has one."""
    name, source = identifier(table.name), c_source(table)
    reason = None
    with whole_file(path) as partial, ZipFile(partial, "w", ZIP_DEFLATED) as unit:
        unit.writestr("modelDescription.xml", description(table))
        unit.writestr(f"sources/{name}.c", source)
        unit.writestr("sources/buildDescription.xml", _build_description(table))
        try:
            place, library = compiled(source)
            unit.writestr(place.format(name), library)
        except NoCompilerError as error:
            reason = str(error)
    return reason
