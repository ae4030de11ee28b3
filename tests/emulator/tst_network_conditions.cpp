#include "network_conditions.h"

#include <QTest>

using namespace lds::emulator;

class NetworkConditionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ipSettingConditionsAreThoseOfTheManual_data();
    void ipSettingConditionsAreThoseOfTheManual();
};

namespace {

quint32 address(const QString& text)
{
    quint32 number = 0;
    for (const QString& octet : text.split(u'.'))
        number = number << 8 | octet.toUInt();
    return number;
}

} // namespace

void NetworkConditionsTest::ipSettingConditionsAreThoseOfTheManual_data()
{
    QTest::addColumn<QString>("ip");
    QTest::addColumn<QString>("mask");
    QTest::addColumn<QString>("gateway");
    QTest::addColumn<QString>("refusedFor"); ///< Part of the reason; empty = allowed.

    const auto row = [](const char* name, const char* ip, const char* mask, const char* gateway,
                        const char* reason) {
        QTest::newRow(name) << QString::fromLatin1(ip) << QString::fromLatin1(mask)
                            << QString::fromLatin1(gateway) << QString::fromLatin1(reason);
    };
    row("default", "192.168.1.6", "255.255.255.0", "192.168.1.1", "");
    row("no gateway", "192.168.1.6", "255.255.255.0", "0.0.0.0", "");
    row("class A", "10.1.2.3", "255.0.0.0", "10.0.0.1", "");
    row("two hosts", "10.0.0.1", "255.255.255.252", "10.0.0.2", "");
    row("largest first octet", "223.1.1.1", "255.255.255.0", "0.0.0.0", "");
    row("first octet 0", "0.168.1.6", "255.255.255.0", "0.0.0.0", "address's first octet");
    row("first octet 127", "127.0.0.1", "255.0.0.0", "0.0.0.0", "address's first octet");
    row("first octet 224", "224.0.0.1", "255.0.0.0", "0.0.0.0", "address's first octet");
    row("first octet 255", "255.0.0.1", "255.0.0.0", "0.0.0.0", "address's first octet");
    row("holes in the mask", "192.168.1.6", "255.0.255.0", "0.0.0.0", "mask");
    row("mask from the right", "192.168.1.6", "0.255.255.255", "0.0.0.0", "mask");
    row("mask 254 in the middle", "192.168.1.6", "255.254.255.0", "0.0.0.0", "mask");
    row("no mask", "192.168.1.6", "0.0.0.0", "0.0.0.0", "mask");
    row("mask of ones", "192.168.1.6", "255.255.255.255", "0.0.0.0", "mask");
    row("host all zeros", "192.168.1.0", "255.255.255.0", "0.0.0.0", "address's host");
    row("host all ones", "192.168.1.255", "255.255.255.0", "0.0.0.0", "address's host");
    row("no host left by 31 bits", "192.168.1.6", "255.255.255.254", "0.0.0.0", "address's host");
    row("network all zeros", "1.0.0.5", "128.0.0.0", "0.0.0.0", "address's network");
    row("gateway's first octet", "192.168.1.6", "255.255.255.0", "127.0.0.1", "gateway's first octet");
    row("gateway's first octet 0", "192.168.1.6", "255.255.255.0", "0.0.0.1", "gateway's first octet");
    row("gateway's host all zeros", "192.168.1.6", "255.255.255.0", "192.168.1.0", "gateway's host");
    row("gateway's host all ones", "192.168.1.6", "255.255.255.0", "192.168.1.255", "gateway's host");
    row("gateway elsewhere", "192.168.1.6", "255.255.255.0", "192.168.2.1", "not in the address's network");
}

void NetworkConditionsTest::ipSettingConditionsAreThoseOfTheManual()
{
    QFETCH(QString, ip);
    QFETCH(QString, mask);
    QFETCH(QString, gateway);
    QFETCH(QString, refusedFor);
    const QString reason = networkObjection(address(ip), address(mask), address(gateway));
    if (refusedFor.isEmpty())
        QCOMPARE(reason, QString());
    else
        QVERIFY2(reason.contains(refusedFor), qPrintable(reason));
}

QTEST_APPLESS_MAIN(NetworkConditionsTest)
#include "tst_network_conditions.moc"
