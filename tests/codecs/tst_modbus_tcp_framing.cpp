#include "modbus_tcp_framing.h"

#include <QTest>

using namespace lds::modbus;

class ModbusTcpFramingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void headerFieldsAreReadBigEndian();
    void frameCarriesTransactionUnitAndComputedLength();
    void frameDecodesToWhatWasEncoded();
};

void ModbusTcpFramingTest::headerFieldsAreReadBigEndian()
{
    const TcpHeader header = decodeHeader(QByteArray::fromHex("1234 0001 0106 f7 0300000001"));
    QCOMPARE(header.transaction, quint16(0x1234));
    QCOMPARE(header.protocol, quint16(1));
    QCOMPARE(header.length, quint16(0x106));
    QCOMPARE(header.unit, quint8(0xf7));
}

void ModbusTcpFramingTest::frameCarriesTransactionUnitAndComputedLength()
{
    // §5.2.3: reading two registers from 400021 (value 20 on the wire), unit 1.
    QCOMPARE(encodeFrame(0xabcd, 1, QByteArray::fromHex("0300140002")),
             QByteArray::fromHex("abcd 0000 0006 01 03 0014 0002"));
}

void ModbusTcpFramingTest::frameDecodesToWhatWasEncoded()
{
    const QByteArray frame = encodeFrame(0xffff, 0xff, QByteArray(253, 'x'));
    const TcpHeader header = decodeHeader(frame);
    QCOMPARE(header.transaction, quint16(0xffff));
    QCOMPARE(header.protocol, quint16(0));
    QCOMPARE(header.length, quint16(254));
    QCOMPARE(header.unit, quint8(0xff));
    QCOMPARE(frame.size(), headerSize + 253);
}

QTEST_APPLESS_MAIN(ModbusTcpFramingTest)
#include "tst_modbus_tcp_framing.moc"
