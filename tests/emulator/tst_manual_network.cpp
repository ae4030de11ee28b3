// §5.1.1 and §5.2.1: moving the sensor into another network by messages.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

using Octets = std::array<int, 4>;
using Items = std::array<ItemId, 4>; ///< 1st octet first.

constexpr Items ipAddress{ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet, ItemId::IpAddress3rdOctet,
                          ItemId::IpAddress4thOctet};
constexpr Items subnetMask{ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet, ItemId::SubnetMask3rdOctet,
                           ItemId::SubnetMask4thOctet};
constexpr Items gateway{ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                        ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet};

QList<ItemWrite> message(const Items& items, const Octets& octets)
{
    QList<ItemWrite> writes;
    for (std::size_t i = 0; i < items.size(); ++i)
        writes.append({items[i], octets[i]});
    return writes;
}

} // namespace

class ManualNetworkTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void defaultsAreThoseOfTheManual();
    void aStepTowardsAPossibleCombinationMayBeRefused();
    void anotherNetworkIsReachedThroughNoGateway();
    void everyConditionIsHeldOfAMessage_data();
    void everyConditionIsHeldOfAMessage();

private:
    std::optional<Refusal> writeAll(const QList<ItemWrite>& writes)
    {
        return m_sensor->write(writes).refusal;
    }
    Octets now(const Items& items)
    {
        Octets octets{};
        for (std::size_t i = 0; i < items.size(); ++i)
            octets[i] = readNow(items[i]);
        return octets;
    }
};

void ManualNetworkTest::defaultsAreThoseOfTheManual()
{
    QCOMPARE(now(ipAddress), (Octets{192, 168, 1, 6}));
    QCOMPARE(now(subnetMask), (Octets{255, 255, 255, 0}));
    QCOMPARE(now(gateway), (Octets{192, 168, 1, 1}));
    QCOMPARE(readNow(ItemId::PortModbus), 502);
    QCOMPARE(readNow(ItemId::PortTool), 49'152);
}

void ManualNetworkTest::aStepTowardsAPossibleCombinationMayBeRefused()
{
    // 10.0.0.5 with the gateway 10.0.0.1 would do; alone, either is in another network than the other.
    QCOMPARE(writeAll(message(ipAddress, {10, 0, 0, 5})), Refusal::Data);
    QCOMPARE(writeAll(message(gateway, {10, 0, 0, 1})), Refusal::Data);
    QCOMPARE(now(ipAddress), (Octets{192, 168, 1, 6}));
    QCOMPARE(now(gateway), (Octets{192, 168, 1, 1}));
}

void ManualNetworkTest::anotherNetworkIsReachedThroughNoGateway()
{
    QVERIFY(!writeAll(message(gateway, {0, 0, 0, 0})));
    QVERIFY(!writeAll(message(ipAddress, {10, 0, 0, 5})));
    QVERIFY(!writeAll(message(subnetMask, {255, 0, 0, 0})));
    QVERIFY(!writeAll(message(gateway, {10, 0, 0, 1})));
    QCOMPARE(now(ipAddress), (Octets{10, 0, 0, 5}));
    QCOMPARE(now(subnetMask), (Octets{255, 0, 0, 0}));
    QCOMPARE(now(gateway), (Octets{10, 0, 0, 1}));
}

void ManualNetworkTest::everyConditionIsHeldOfAMessage_data()
{
    QTest::addColumn<QList<ItemWrite>>("writes");
    const auto row = [](const char* name, const Items& items, const Octets& octets) {
        QTest::newRow(name) << message(items, octets);
    };
    row("1: address 0.x", ipAddress, {0, 168, 1, 6});
    row("1: address 127.x", ipAddress, {127, 168, 1, 6});
    row("1: address 224.x", ipAddress, {224, 168, 1, 6});
    row("1: address 255.x", ipAddress, {255, 168, 1, 6});
    row("2: mask with a hole", subnetMask, {255, 0, 255, 0});
    row("3: host all zeros", ipAddress, {192, 168, 1, 0});
    row("3: host all ones", ipAddress, {192, 168, 1, 255});
    row("4: gateway 0.x", gateway, {0, 0, 0, 1});
    row("4: gateway 127.x", gateway, {127, 168, 1, 1});
    row("4: gateway 224.x", gateway, {224, 168, 1, 1});
    row("5: gateway's host all zeros", gateway, {192, 168, 1, 0});
    row("5: gateway's host all ones", gateway, {192, 168, 1, 255});
    row("6: gateway in another network", gateway, {192, 168, 2, 1});
    row("6: mask that parts them", subnetMask, {255, 255, 255, 252});
}

void ManualNetworkTest::everyConditionIsHeldOfAMessage()
{
    QFETCH(QList<ItemWrite>, writes);
    QCOMPARE(writeAll(writes), Refusal::Data);
    defaultsAreThoseOfTheManual();
}

QTEST_GUILESS_MAIN(ManualNetworkTest)
#include "tst_manual_network.moc"
