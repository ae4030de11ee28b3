"""Reads and writes two virtual sensors on one serial line with pymodbus.

Arguments: link, speed, parity (N, E or O). Unit 11 is an HL-G203B-S-MK, unit 12 an HL-G205B-S-MK.
Every check prints a line; the first one that does not hold ends the program with 1.
"""
import sys
import time

from pymodbus.client import ModbusSerialClient

link, speed, parity = sys.argv[1], int(sys.argv[2]), sys.argv[3]


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


def opened(speed, parity, timeout=3, **more):
    # Not strict: that sets the port a second time, which Debian's C library refuses for a pseudo-terminal
    # when there is parity.
    client = ModbusSerialClient(link, baudrate=speed, parity=parity, stopbits=2 if parity == "N" else 1,
                                timeout=timeout, strict=False, **more)
    check("connects", client.connect(), True)
    return client


def registers(client, unit, number, count):
    answer = client.read_holding_registers(wire(number), count, slave=unit)
    check(f"reading {number} of unit {unit} is no error", answer.isError(), False)
    return answer.registers


def refusal(answer):
    return getattr(answer, "exception_code", -1) if answer.isError() else 0


def turnaround():
    """Lets what has been sent go out: pymodbus knows when it has written, not when the line is quiet.

    After a broadcast Modbus prescribes such a pause, since no answer tells that it has been heard.
    """
    time.sleep(0.1)


def main():
    client = opened(speed, parity, broadcast_enable=True)
    check("HIGH", signed(registers(client, 11, 400101, 2)), 50000)
    check("HIGH", signed(registers(client, 12, 400101, 2)), 100000)
    check("addresses", [registers(client, unit, 400169, 1) for unit in (11, 12)], [[11], [12]])
    check("most", len(registers(client, 12, 400020, 125)), 125)
    coils = client.read_coils(0, 64, slave=11).bits
    check("coils", [number for number, on in enumerate(coils, 1) if on], [4, 7, 11])

    check("write one", refusal(client.write_register(wire(400110), 4321, slave=11)), 0)
    check("is written", registers(client, 11, 400110, 1), [4321])
    check("not to the other", registers(client, 12, 400110, 1), [8])
    window = words(90000) + words(-90000)
    check("write window", refusal(client.write_registers(wire(400101), window, slave=11)), 0)
    check("is written", [signed(registers(client, 11, 400101 + i, 2)) for i in (0, 2)], [90000, -90000])

    check("01", refusal(client.read_input_registers(wire(400101), 1, slave=11)), 1)
    check("01", refusal(client.write_coil(0, True, slave=12)), 1)
    check("02", refusal(client.read_holding_registers(wire(400051), 1, slave=11)), 2)
    check("02", refusal(client.read_coils(64, 1, slave=12)), 2)
    check("03", refusal(client.write_register(wire(400062), 7, slave=11)), 3)
    check("03", refusal(client.write_registers(wire(400103), words(90000), slave=11)), 3)
    check("04", refusal(client.write_register(wire(400146), 0, slave=12)), 4)

    client.write_register(wire(400109), 0, slave=0)  # to all, and nobody answers
    turnaround()
    check("all obey", [registers(client, unit, 400109, 1) for unit in (11, 12)], [[0], [0]])
    client.write_registers(wire(400110), [77], slave=0)
    turnaround()
    check("all obey", [registers(client, unit, 400110, 1) for unit in (11, 12)], [[77], [77]])
    client.close()

    other = opened(57600, "O", timeout=1, retries=0)
    check("no answer at another speed", other.read_holding_registers(wire(400116), 1, slave=11).isError(), True)
    other.close()
    turnaround()
    again = opened(speed, parity)
    check("span", signed(registers(again, 11, 400116, 2)), 10000)
    again.close()
    print("done")


main()
