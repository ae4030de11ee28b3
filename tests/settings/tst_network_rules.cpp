#include "rules.h"

#include "settings_text.h"

#include <QtTest>

using namespace lds::settings;
using namespace lds::settings::test;
using namespace lds::catalog;

namespace {

constexpr auto model = SensorModel::HlG203;
constexpr const char* any = nullptr;

Values network(const char* ip, const char* mask, const char* gateway)
{
    Values values;
    if (ip)
        values.insert(address(WriteGroup::IpAddress, ip));
    if (mask)
        values.insert(address(WriteGroup::SubnetMask, mask));
    if (gateway)
        values.insert(address(WriteGroup::DefaultGateway, gateway));
    return values;
}

} // namespace

Q_DECLARE_METATYPE(std::optional<Rule>)

/// §5.2.1 "IP setting conditions" and §5.1.1 "combination error check"
class NetworkRulesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aWriteIsJudgedWithTheOtherGroupsAsTheyAre_data();
    void aWriteIsJudgedWithTheOtherGroupsAsTheyAre();
    void everyFirstOctetIsJudged();
    void everyMaskIsJudged();
    void theOctetsOfAnAddressComeTogether();
    void partsThatAreUnknownDoNotBlock();
    void aWriteDoesNotAnswerForRulesItDoesNotTouch();
    void checkFindsEachConditionOfTheManual();
};

void NetworkRulesTest::aWriteIsJudgedWithTheOtherGroupsAsTheyAre_data()
{
    QTest::addColumn<Values>("state");
    QTest::addColumn<Write>("write");
    QTest::addColumn<std::optional<Rule>>("refused");

    const auto row = [](const char* name, const Values& state, WriteGroup group, const char* value,
                        std::optional<Rule> refused) {
        QTest::newRow(name) << state << addressWrite(group, value) << refused;
    };
    const Values factory = network("192.168.1.6", "255.255.255.0", "192.168.1.1");
    const Values alone = network("192.168.1.6", "255.255.255.0", "0.0.0.0");

    row("address in the same subnet", factory, WriteGroup::IpAddress, "192.168.1.200", std::nullopt);
    row("address away from the gateway", factory, WriteGroup::IpAddress, "192.168.2.6",
        Rule::GatewayOtherNetwork);
    row("the same without a gateway", alone, WriteGroup::IpAddress, "192.168.2.6", std::nullopt);
    row("address with first octet 0", alone, WriteGroup::IpAddress, "0.168.1.6", Rule::AddressFirstOctet);
    row("loopback address", alone, WriteGroup::IpAddress, "127.0.0.1", Rule::AddressFirstOctet);
    row("multicast address", alone, WriteGroup::IpAddress, "224.0.0.1", Rule::AddressFirstOctet);
    row("host part all zeros", alone, WriteGroup::IpAddress, "10.0.0.0", Rule::AddressHostBits);
    row("host part all ones", alone, WriteGroup::IpAddress, "10.0.0.255", Rule::AddressHostBits);
    row("ones are judged by the mask", network(any, "255.255.0.0", "0.0.0.0"), WriteGroup::IpAddress,
        "10.0.0.255", std::nullopt);
    row("network part all zeros", network(any, "128.0.0.0", any), WriteGroup::IpAddress, "10.0.0.1",
        Rule::AddressNetworkBits);

    row("shorter mask", factory, WriteGroup::SubnetMask, "255.255.0.0", std::nullopt);
    row("mask with a hole", factory, WriteGroup::SubnetMask, "255.0.255.0", Rule::MaskNotContiguous);
    row("mask that makes the host part ones", alone, WriteGroup::SubnetMask, "255.255.255.254",
        Rule::AddressHostBits);
    row("mask that leaves no host part", alone, WriteGroup::SubnetMask, "255.255.255.255",
        Rule::AddressHostBits);
    row("mask that leaves no network part", alone, WriteGroup::SubnetMask, "0.0.0.0",
        Rule::AddressNetworkBits);
    row("mask that makes the gateway's host part ones",
        network("192.168.1.6", "255.255.255.0", "192.168.1.7"), WriteGroup::SubnetMask, "255.255.255.248",
        Rule::GatewayHostBits);
    row("mask that parts address and gateway", network("192.168.1.6", "255.255.255.0", "192.168.1.130"),
        WriteGroup::SubnetMask, "255.255.255.128", Rule::GatewayOtherNetwork);

    row("gateway in the same subnet", alone, WriteGroup::DefaultGateway, "192.168.1.254", std::nullopt);
    row("no gateway", factory, WriteGroup::DefaultGateway, "0.0.0.0", std::nullopt);
    row("gateway elsewhere", alone, WriteGroup::DefaultGateway, "192.168.2.1", Rule::GatewayOtherNetwork);
    row("gateway with first octet 0", alone, WriteGroup::DefaultGateway, "0.0.0.1", Rule::GatewayFirstOctet);
    row("gateway 255.255.255.255", alone, WriteGroup::DefaultGateway, "255.255.255.255",
        Rule::GatewayFirstOctet);
    row("gateway with host part zeros", alone, WriteGroup::DefaultGateway, "192.168.1.0",
        Rule::GatewayHostBits);
    row("gateway with host part ones", alone, WriteGroup::DefaultGateway, "192.168.1.255",
        Rule::GatewayHostBits);
}

void NetworkRulesTest::aWriteIsJudgedWithTheOtherGroupsAsTheyAre()
{
    QFETCH(Values, state);
    QFETCH(Write, write);
    QFETCH(std::optional<Rule>, refused);
    const auto next = apply(model, state, write);
    QCOMPARE(next ? std::nullopt : std::optional(next.error().rule), refused);
    if (!next)
        QCOMPARE(next.error().items.first(), write.first().item);
}

void NetworkRulesTest::everyFirstOctetIsJudged()
{
    for (int first = 0; first <= 255; ++first) {
        const QByteArray dotted = QByteArray::number(first) + ".1.1.1";
        const bool allowed = first != 0 && first != 127 && !(first >= 224);
        QCOMPARE(apply(model, {}, addressWrite(WriteGroup::IpAddress, dotted)).has_value(), allowed);
        QCOMPARE(apply(model, {}, addressWrite(WriteGroup::DefaultGateway, dotted)).has_value(), allowed);
    }
}

/// Against all masks that differ from a contiguous one by a bit, too.
void NetworkRulesTest::everyMaskIsJudged()
{
    const auto dottedOf = [](quint32 mask) {
        return QStringLiteral("%1.%2.%3.%4")
            .arg(mask >> 24)
            .arg(mask >> 16 & 255)
            .arg(mask >> 8 & 255)
            .arg(mask & 255);
    };
    QSet<quint32> contiguous{0};
    for (int bits = 1; bits <= 32; ++bits)
        contiguous << quint32(0xffffffffU << (32 - bits));
    QCOMPARE(contiguous.size(), 33);
    for (const quint32 good : std::as_const(contiguous)) {
        for (int flipped = -1; flipped < 32; ++flipped) {
            const quint32 mask = flipped < 0 ? good : good ^ (1U << flipped);
            const auto next =
                apply(model, {}, addressWrite(WriteGroup::SubnetMask, dottedOf(mask).toLatin1()));
            QCOMPARE(next.has_value(), contiguous.contains(mask));
            if (!next)
                QCOMPARE(next.error().rule, Rule::MaskNotContiguous);
        }
    }
}

void NetworkRulesTest::theOctetsOfAnAddressComeTogether()
{
    const Values factory = network("192.168.1.6", "255.255.255.0", "192.168.1.1");
    for (const WriteGroup group :
         {WriteGroup::IpAddress, WriteGroup::SubnetMask, WriteGroup::DefaultGateway}) {
        Write write = addressWrite(group, "192.168.1.9");
        write.removeAt(2);
        const auto next = apply(model, factory, write);
        QVERIFY(!next);
        QCOMPARE(next.error().rule, Rule::GroupIncomplete);
    }
    QCOMPARE(apply(model, factory, {{ItemId::IpAddress4thOctet, 256}}).error().rule, Rule::OutOfRange);
}

void NetworkRulesTest::partsThatAreUnknownDoNotBlock()
{
    QVERIFY(apply(model, {}, addressWrite(WriteGroup::IpAddress, "10.0.0.0")));
    Values oneOctetMissing = network("192.168.1.6", "255.255.255.0", "192.168.1.1");
    oneOctetMissing.remove(ItemId::DefaultGateway4thOctet);
    QVERIFY(apply(model, oneOctetMissing, addressWrite(WriteGroup::IpAddress, "10.0.0.5")));
}

void NetworkRulesTest::aWriteDoesNotAnswerForRulesItDoesNotTouch()
{
    // The address is none, but the gateway is not to blame for that.
    const Values badAddress = network("0.0.0.5", any, "0.0.0.0");
    QVERIFY(apply(model, badAddress, addressWrite(WriteGroup::DefaultGateway, "10.0.0.1")));
    QVERIFY(apply(model, network("192.168.1.6", "255.0.255.0", "1.2.3.4"), {{ItemId::Span, 10'000}}));
    // Nor is a new address for a mask with a hole.
    QVERIFY(apply(model, network(any, "255.0.255.0", any), addressWrite(WriteGroup::IpAddress, "10.1.1.1")));
}

void NetworkRulesTest::checkFindsEachConditionOfTheManual()
{
    const auto broken = [](const char* ip, const char* mask, const char* gateway) {
        QList<Rule> rules;
        for (const Refusal& refusal : check(model, network(ip, mask, gateway)))
            rules << refusal.rule;
        return rules;
    };
    QCOMPARE(broken("192.168.1.6", "255.255.255.0", "192.168.1.1"), QList<Rule>());
    QCOMPARE(broken("127.0.0.6", "255.255.255.0", "0.0.0.0"), (QList{Rule::AddressFirstOctet}));
    QCOMPARE(broken("10.0.0.6", "255.0.255.0", "0.0.0.0"), (QList{Rule::MaskNotContiguous}));
    QCOMPARE(broken("10.0.0.0", "255.255.255.0", "0.0.0.0"), (QList{Rule::AddressHostBits}));
    QCOMPARE(broken("10.0.0.1", "128.0.0.0", "0.0.0.0"), (QList{Rule::AddressNetworkBits}));
    QCOMPARE(broken("10.0.0.1", "255.0.0.0", "240.0.0.1"),
             (QList{Rule::GatewayFirstOctet, Rule::GatewayOtherNetwork}));
    QCOMPARE(broken("10.0.0.1", "255.255.255.0", "10.0.0.0"), (QList{Rule::GatewayHostBits}));
    QCOMPARE(broken("10.0.0.1", "255.255.255.0", "10.0.1.1"), (QList{Rule::GatewayOtherNetwork}));
}

QTEST_APPLESS_MAIN(NetworkRulesTest)
#include "tst_network_rules.moc"
