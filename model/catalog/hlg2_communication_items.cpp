#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

/// One octet of an address; Modbus only.
constexpr SettingItem octet(const Words& words, int modbus, WriteGroup group, Value defaultValue)
{
    return inGroup(
        row(words, communicationSetting, Kind::Octet, {1, modbus}, sameForAll({0, 255, defaultValue})),
        group);
}

constexpr auto addressHelp =
    QT_TRANSLATE_NOOP("SettingItem", "One of the four numbers of the sensor's own address, written together. "
                                     "The first cannot be 0, 127 or 224 to 255, "
                                     "the host part not all zeros or ones, and address and gateway have to "
                                     "be in one subnet: if a change is refused, set "
                                     "the gateway to 0.0.0.0 first. Counts after a communication reset or "
                                     "restart; connect to the new address then.");
constexpr auto maskHelp =
    QT_TRANSLATE_NOOP("SettingItem", "One of the four numbers of the subnet mask, written together: ones "
                                     "from the left, then only zeros, as in "
                                     "255.255.255.0. It has to suit the address and the gateway. Counts "
                                     "after a communication reset or restart.");
constexpr auto gatewayHelp =
    QT_TRANSLATE_NOOP("SettingItem", "One of the four numbers of the way out of the subnet, written "
                                     "together; 0.0.0.0 means that there is none. Otherwise "
                                     "it has to be in the same subnet as the sensor, its first number not 0, "
                                     "127 or 224 to 255. Counts after a "
                                     "communication reset or restart.");

constexpr SettingItem ethernetRows[] = {
    row({ItemId::PortModbus, "portModbus", 75, QT_TRANSLATE_NOOP("SettingItem", "Port No. (Modbus)"), "5.2.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The port at which a PLC or other host reaches the sensor by Modbus TCP. 44818 is taken, and it "
             "has to differ from the tool port. Counts after a communication reset or restart.")},
        communicationSetting, Kind::Port, {2, 400153}, sameForAll({1, 65'535, 502})),
    row({ItemId::PortTool, "portTool", 74, QT_TRANSLATE_NOOP("SettingItem", "Port No. (Tool)"), "5.2.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The port at which configuration software reaches the sensor. 44818 is taken, and it has to "
             "differ from the Modbus port. Counts after a communication reset or restart; use the new port "
             "to connect then.")},
        communicationSetting, Kind::Port, {2, 400154}, sameForAll({1, 65'535, 49'152})),
    octet({ItemId::IpAddress4thOctet, "ipAddress4thOctet", 71,
           QT_TRANSLATE_NOOP("SettingItem", "IP Address (4th octet)"), "5.2.1", addressHelp},
          400155, WriteGroup::IpAddress, 6),
    octet({ItemId::IpAddress3rdOctet, "ipAddress3rdOctet", 71,
           QT_TRANSLATE_NOOP("SettingItem", "IP Address (3rd octet)"), "5.2.1", addressHelp},
          400156, WriteGroup::IpAddress, 1),
    octet({ItemId::IpAddress2ndOctet, "ipAddress2ndOctet", 71,
           QT_TRANSLATE_NOOP("SettingItem", "IP Address (2nd octet)"), "5.2.1", addressHelp},
          400157, WriteGroup::IpAddress, 168),
    octet({ItemId::IpAddress1stOctet, "ipAddress1stOctet", 71,
           QT_TRANSLATE_NOOP("SettingItem", "IP Address (1st octet)"), "5.2.1", addressHelp},
          400158, WriteGroup::IpAddress, 192),
    octet({ItemId::SubnetMask4thOctet, "subnetMask4thOctet", 72,
           QT_TRANSLATE_NOOP("SettingItem", "Subnet Mask (4th octet)"), "5.2.1", maskHelp},
          400159, WriteGroup::SubnetMask, 0),
    octet({ItemId::SubnetMask3rdOctet, "subnetMask3rdOctet", 72,
           QT_TRANSLATE_NOOP("SettingItem", "Subnet Mask (3rd octet)"), "5.2.1", maskHelp},
          400160, WriteGroup::SubnetMask, 255),
    octet({ItemId::SubnetMask2ndOctet, "subnetMask2ndOctet", 72,
           QT_TRANSLATE_NOOP("SettingItem", "Subnet Mask (2nd octet)"), "5.2.1", maskHelp},
          400161, WriteGroup::SubnetMask, 255),
    octet({ItemId::SubnetMask1stOctet, "subnetMask1stOctet", 72,
           QT_TRANSLATE_NOOP("SettingItem", "Subnet Mask (1st octet)"), "5.2.1", maskHelp},
          400162, WriteGroup::SubnetMask, 255),
    octet({ItemId::DefaultGateway4thOctet, "defaultGateway4thOctet", 73,
           QT_TRANSLATE_NOOP("SettingItem", "Default Gateway (4th octet)"), "5.2.1", gatewayHelp},
          400163, WriteGroup::DefaultGateway, 1),
    octet({ItemId::DefaultGateway3rdOctet, "defaultGateway3rdOctet", 73,
           QT_TRANSLATE_NOOP("SettingItem", "Default Gateway (3rd octet)"), "5.2.1", gatewayHelp},
          400164, WriteGroup::DefaultGateway, 1),
    octet({ItemId::DefaultGateway2ndOctet, "defaultGateway2ndOctet", 73,
           QT_TRANSLATE_NOOP("SettingItem", "Default Gateway (2nd octet)"), "5.2.1", gatewayHelp},
          400165, WriteGroup::DefaultGateway, 168),
    octet({ItemId::DefaultGateway1stOctet, "defaultGateway1stOctet", 73,
           QT_TRANSLATE_NOOP("SettingItem", "Default Gateway (1st octet)"), "5.2.1", gatewayHelp},
          400166, WriteGroup::DefaultGateway, 192),
    row({ItemId::PortSlmp, "portSlmp", 76, QT_TRANSLATE_NOOP("SettingItem", "Port No. (SLMP)"), "5.4.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The UDP port at which the sensor answers SLMP. 2222, 9090 and 44818 are taken. No protocol "
             "gives access to it: read and set it with the sensor's keys.")},
        keypadSetting, Kind::Port, {}, sameForAll({1, 65'535, 45'237})),
    row({ItemId::NetworkNumber, "networkNumber", 77, QT_TRANSLATE_NOOP("SettingItem", "Network No."), "5.4.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The SLMP network the sensor belongs to. 0 goes with node number 255 only; 1 to 239 ask for a "
             "node number of 1 to 120, 125 or 126. No protocol gives access to it: read and set it with "
             "the sensor's keys.")},
        keypadSetting, Kind::Count, {}, sameForAll({0, 239, 0})),
    // Not every number between is legal: 1 to 120, 125, 126 and 255 (§5.4.1).
    row({ItemId::NodeNumber, "nodeNumber", 77, QT_TRANSLATE_NOOP("SettingItem", "Node No."), "5.4.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The sensor's station number in its SLMP network: 255 with network number 0, else 1 to 120, 125 "
             "or 126. No protocol gives access to it: read and set it with the sensor's keys.")},
        keypadSetting, Kind::Count, {}, sameForAll({1, 255, 255})),
    withoutDefault(row(
        {ItemId::MacAddress, "macAddress", 78, QT_TRANSLATE_NOOP("SettingItem", "MAC Address"), "5.1.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The hardware address the sensor was built with. It can be looked at on the sensor's display "
             "and cannot be changed; Modbus does not report it.")},
        {Role::Status, Access::None, Scope::Common}, Kind::MacAddress, {}, sameForAll({0, 0, 0}))),
};

constexpr Choice speeds[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "9600 bps")},
                             {1, QT_TRANSLATE_NOOP("SettingItem", "19200 bps")},
                             {2, QT_TRANSLATE_NOOP("SettingItem", "38400 bps")},
                             {3, QT_TRANSLATE_NOOP("SettingItem", "115200 bps")},
                             {4, QT_TRANSLATE_NOOP("SettingItem", "230400 bps")}};

constexpr Choice parities[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "NON + 2bit")},
                               {1, QT_TRANSLATE_NOOP("SettingItem", "EVEN + 1bit")},
                               {2, QT_TRANSLATE_NOOP("SettingItem", "ODD + 1bit")}};

constexpr SettingItem serialRows[] = {
    choice({ItemId::CommunicationSpeed, "communicationSpeed", 83,
            QT_TRANSLATE_NOOP("SettingItem", "Communication speed"), "6.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Speed of the RS-485 line, the same for all devices on it. With several sensors take the "
                "fastest that the line allows, else the values arrive slowly. Counts after a "
                "communication reset or restart.")},
           communicationSetting, {1, 400167}, speeds, 2),
    choice({ItemId::ParityStopBit, "parityStopBit", 84, QT_TRANSLATE_NOOP("SettingItem", "Parity/Stop Bit"),
            "6.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Parity and stop bits of the RS-485 line, the same for all devices on it. Counts after a "
                "communication reset or restart.")},
           communicationSetting, {1, 400168}, parities, 1),
    row({ItemId::DeviceAddress, "deviceAddress", 82, QT_TRANSLATE_NOOP("SettingItem", "Device Address"),
         "6.2",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The sensor's Modbus RTU address. No two devices on one line may have the same. Counts after a "
             "communication reset or restart.")},
        communicationSetting, Kind::Count, {1, 400169}, sameForAll({1, 247, 1})),
    choice({ItemId::TerminationResistance, "terminationResistance", 81,
            QT_TRANSLATE_NOOP("SettingItem", "Termination resistance"), "6.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "ON for the sensor at the end of the RS-485 line, OFF for all between. Counts after a "
                "communication reset or restart.")},
           communicationSetting, {1, 400170}, offOn, 1),
};

} // namespace

std::span<const SettingItem> ethernetItems() { return ethernetRows; }
std::span<const SettingItem> serialItems() { return serialRows; }

} // namespace lds::catalog::hlg2
