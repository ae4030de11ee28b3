// A Modbus TCP server on libmodbus: libmodbus_server REGISTERS ADDRESS=VALUE…
// Serves one client after another on a free loopback port, which it prints on standard output.

#include <arpa/inet.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <modbus.h>
#include <sys/socket.h>
#include <unistd.h>

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

int portOf(int socket)
{
    sockaddr_in address = {};
    socklen_t size = sizeof address;
    return getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0 ? ntohs(address.sin_port)
                                                                                  : 0;
}

void serve(modbus_t* context, modbus_mapping_t* mapping)
{
    uint8_t query[MODBUS_TCP_MAX_ADU_LENGTH];
    for (;;) {
        const int size = modbus_receive(context, query);
        if (size < 0)
            return;
        if (size > 0)
            modbus_reply(context, query, size, mapping);
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
        return 2;
    modbus_t* const context = modbus_new_tcp("127.0.0.1", 0);
    modbus_mapping_t* const mapping = modbus_mapping_new(0, 0, std::atoi(argv[1]), 0);
    if (!context || !mapping)
        return 1;
    fill(mapping, argc - 2, argv + 2);
    int listening = modbus_tcp_listen(context, 4);
    if (listening < 0)
        return 1;
    std::printf("%d\n", portOf(listening));
    std::fflush(stdout);
    while (modbus_tcp_accept(context, &listening) >= 0) {
        serve(context, mapping);
        modbus_close(context);
    }
    return 1;
}
