"""Reads and writes a virtual HL-G203B-S-MK with pymodbus; the port is the argument.

Every check prints a line; the first one that does not hold ends the program with 1.
"""
import importlib
import sys
import types


def stand_in(module, **contents):
    """pymodbus's clients import the serial modules even for TCP; Debian only recommends their packages."""
    try:
        importlib.import_module(module)
    except ImportError:
        sys.modules[module] = types.ModuleType(module)
        vars(sys.modules[module]).update(contents)


stand_in("serial")
stand_in("serial_asyncio", create_serial_connection=None)

from pymodbus.client import ModbusTcpClient  # noqa: E402


def wire(number):
    """Address on the wire of a register as the manual prints it."""
    return number - 400001


def signed(words):
    """Two registers, low word first, as one signed value."""
    value = words[1] << 16 | words[0]
    return value - (1 << 32) if value & 0x80000000 else value


def words(value):
    return [value & 0xFFFF, value >> 16 & 0xFFFF]


def check(name, actual, expected):
    if actual != expected:
        print(f"FAILED {name}: {actual!r} instead of {expected!r}")
        sys.exit(1)
    print(f"ok {name}")


def registers(client, number, count):
    answer = client.read_holding_registers(wire(number), count, slave=1)
    check(f"reading {number} is no error", answer.isError(), False)
    return answer.registers


def refusal(answer):
    return answer.exception_code if answer.isError() else 0


def main():
    client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]), timeout=5)
    check("connects", client.connect(), True)

    check("defaults", registers(client, 400108, 8), [0, 1, 8, 0, 0, 3, 5, 0])
    check("HIGH", signed(registers(client, 400101, 2)), 50000)
    check("LOW", signed(registers(client, 400103, 2)), -50000)
    check("IP address", registers(client, 400155, 4), [6, 1, 168, 192])
    check("unmapped reads as 0", registers(client, 400107, 3), [0, 0, 1])

    coils = client.read_coils(0, 16, slave=1).bits
    check("coils", [number for number, on in enumerate(coils, 1) if on], [4, 7, 11])

    check("write one", refusal(client.write_register(wire(400110), 4321, slave=1)), 0)
    check("is written", registers(client, 400110, 1), [4321])
    window = words(90000) + words(-90001)
    check("write window", refusal(client.write_registers(wire(400101), window, slave=1)), 0)
    check("is written", [signed(registers(client, 400101 + i, 2)) for i in (0, 2)], [90000, -90001])
    check("write across an unmapped register",
          refusal(client.write_registers(wire(400107), [9, 1, 0], slave=1)), 0)
    check("is written", registers(client, 400107, 3), [0, 1, 0])

    check("01", refusal(client.read_input_registers(wire(400101), 1, slave=1)), 1)
    check("01", refusal(client.write_coil(0, True, slave=1)), 1)
    check("02", refusal(client.read_holding_registers(wire(400051), 1, slave=1)), 2)
    check("02", refusal(client.read_coils(64, 1, slave=1)), 2)
    check("02", refusal(client.write_registers(wire(400052), [1, 0], slave=1)), 2)
    check("03", refusal(client.write_register(wire(400062), 7, slave=1)), 3)
    check("03", refusal(client.write_register(wire(400101), 1, slave=1)), 3)
    check("03", refusal(client.write_registers(wire(400103), words(90000), slave=1)), 3)
    check("04", refusal(client.write_register(wire(400146), 0, slave=1)), 4)
    check("nothing changed", signed(registers(client, 400103, 2)), -90001)
    client.close()
    print("done")


main()
