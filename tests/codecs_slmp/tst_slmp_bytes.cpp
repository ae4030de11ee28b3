#include "slmp_device.h"
#include "slmp_reader.h"
#include "slmp_writer.h"

#include <QTest>

using namespace lds::slmp;

class SlmpBytesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void numbersAreLittleEndian();
    void aReaderNeverPassesTheEnd();
    void aReaderThatFailedReadsNothingMore();
    void sizesBelowZeroFail();
    void bitsArePackedTwoAByteTheFirstOnTop();
};

void SlmpBytesTest::numbersAreLittleEndian()
{
    const QByteArray bytes = QByteArray::fromHex("01 0302 060504 0a090807 0b0c");
    Writer writer;
    writer.u8(0x01).u16(0x0203).u24(0x040506).u32(0x0708090a).bytes("\x0b\x0c");
    QCOMPARE(writer.result(), bytes);
    Reader reader(bytes);
    QCOMPARE(reader.u8(), quint8(0x01));
    QCOMPARE(reader.u16(), quint16(0x0203));
    QCOMPARE(reader.u24(), 0x040506U);
    QCOMPARE(reader.u32(), 0x0708090aU);
    QVERIFY(!reader.finished());
    QCOMPARE(reader.rest(), QByteArray("\x0b\x0c"));
    QVERIFY(reader.finished());
}

void SlmpBytesTest::aReaderNeverPassesTheEnd()
{
    const QByteArray bytes = QByteArray::fromHex("010203");
    for (int size = 0; size <= 8; ++size) {
        Reader reader(bytes);
        QCOMPARE(reader.bytes(size), size <= 3 ? bytes.left(size) : QByteArray());
        QCOMPARE(reader.failed(), size > 3);
        QCOMPARE(reader.finished(), size == 3);
    }
    Reader reader(bytes);
    QCOMPARE(reader.u32(), 0U); // not the three bytes that are there
    QVERIFY(reader.failed());
    Reader huge(bytes);
    huge.skip(std::numeric_limits<qsizetype>::max());
    QVERIFY(huge.failed());
}

void SlmpBytesTest::aReaderThatFailedReadsNothingMore()
{
    const QByteArray bytes = QByteArray::fromHex("010203");
    Reader reader(bytes);
    reader.skip(4);
    QCOMPARE(reader.u8(), quint8(0));
    QVERIFY(reader.rest().isEmpty());
    QVERIFY(reader.failed());
    QVERIFY(!reader.finished());
}

void SlmpBytesTest::sizesBelowZeroFail()
{
    const QByteArray bytes = QByteArray::fromHex("010203");
    Reader reader(bytes);
    QVERIFY(reader.bytes(-1).isEmpty());
    QVERIFY(reader.failed());
}

void SlmpBytesTest::bitsArePackedTwoAByteTheFirstOnTop()
{
    QCOMPARE(packBits({true}), QByteArray::fromHex("10"));
    QCOMPARE(packBits({false, true}), QByteArray::fromHex("01"));
    QCOMPARE(packBits({true, true, false, true, true}), QByteArray::fromHex("110110"));
    QVERIFY(packBits({}).isEmpty());
    for (int count = 0; count <= 144; ++count) {
        QList<bool> bits;
        for (int i = 0; i < count; ++i)
            bits.append(i % 3 == 0);
        QCOMPARE(packBits(bits).size(), packedSize(count));
        QCOMPARE(unpackBits(packBits(bits), count), bits);
        QVERIFY(!unpackBits(packBits(bits) + '\0', count));
        QVERIFY(!unpackBits(packBits(bits).chopped(count ? 1 : 0), count ? count : 1));
    }
}

QTEST_APPLESS_MAIN(SlmpBytesTest)
#include "tst_slmp_bytes.moc"
