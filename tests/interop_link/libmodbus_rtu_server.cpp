// Modbus RTU units on libmodbus: libmodbus_rtu_server PORT BAUD PARITY UNIT REGISTERS ADDRESS=VALUE…
// Serves one unit on a serial port until it is ended. Says "ready" on standard output.

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <modbus.h>

namespace {

void fill(modbus_mapping_t* mapping, int count, char** pairs)
{
    for (int i = 0; i < count; ++i) {
        char* value = nullptr;
        const long address = std::strtol(pairs[i], &value, 10);
        if (address >= 0 && address < mapping->nb_registers && *value == '=')
            mapping->tab_registers[address] = uint16_t(std::strtol(value + 1, nullptr, 10));
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 6)
        return 2;
    modbus_t* const context =
        modbus_new_rtu(argv[1], std::atoi(argv[2]), argv[3][0], 8, argv[3][0] == 'N' ? 2 : 1);
    modbus_mapping_t* const mapping = modbus_mapping_new(64, 0, std::atoi(argv[5]), 0);
    if (!context || !mapping || modbus_set_slave(context, std::atoi(argv[4])) != 0)
        return 1;
    fill(mapping, argc - 6, argv + 6);
    if (modbus_connect(context) != 0) {
        std::fprintf(stderr, "%s: %s\n", argv[1], modbus_strerror(errno));
        return 1;
    }
    std::printf("ready\n");
    std::fflush(stdout);
    for (;;) {
        uint8_t query[MODBUS_RTU_MAX_ADU_LENGTH];
        const int size = modbus_receive(context, query);
        if (size > 0)
            modbus_reply(context, query, size, mapping);
    }
}
