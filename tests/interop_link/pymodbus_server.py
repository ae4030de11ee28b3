"""A Modbus TCP server on pymodbus: pymodbus_server.py REGISTERS ADDRESS=VALUE...

Serves on a free loopback port, which it prints on standard output.
"""

import asyncio
import logging
import sys
import types


def stand_in(name, **attributes):
    """pymodbus imports these for serial lines, which a TCP server never opens."""
    try:
        __import__(name)
    except ImportError:
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(attributes)


stand_in("serial")
stand_in("serial_asyncio", create_serial_connection=None)

# pylint: disable=wrong-import-position
from pymodbus.datastore import (
    ModbusSequentialDataBlock,
    ModbusServerContext,
    ModbusSlaveContext,
)
from pymodbus.server import StartAsyncTcpServer


async def main():
    values = [0] * int(sys.argv[1])
    for pair in sys.argv[2:]:
        address, value = pair.split("=")
        if int(address) < len(values):
            values[int(address)] = int(value)
    slave = ModbusSlaveContext(hr=ModbusSequentialDataBlock(0, values), zero_mode=True)
    context = ModbusServerContext(slaves=slave, single=True)
    server = await StartAsyncTcpServer(context, address=("127.0.0.1", 0), defer_start=True)
    serving = asyncio.ensure_future(server.serve_forever())
    await server.serving
    print(server.server.sockets[0].getsockname()[1], flush=True)
    await serving


logging.disable(logging.ERROR)  # It reports every closed connection as one.
asyncio.run(main())
