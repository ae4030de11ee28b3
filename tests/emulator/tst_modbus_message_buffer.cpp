#include "modbus_message_buffer.h"

#include <QTest>

using namespace lds::emulator;
using State = ModbusMessageBuffer::State;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }
const QByteArray first = hex("0001 0000 0006 01 03 0064 0002");
const QByteArray second = hex("0002 0000 0006 02 01 0000 0010");

} // namespace

class ModbusMessageBufferTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aWholeMessageIsTakenAtOnce();
    void severalMessagesAtOnceAreTakenInOrder();
    void aMessageInPiecesIsTakenWithItsLastByte();
    void bytesThatDoNotAddUpAreKeptUntilDiscarded();
    void foreignProtocolsAndShortMessagesAreLeftOut_data();
    void foreignProtocolsAndShortMessagesAreLeftOut();
    void moreThan270BytesAreOverlong();
    void anUnfinishedBufferBeyond270BytesIsOverlong();
    void aLongestMessageIsTaken();
};

void ModbusMessageBufferTest::aWholeMessageIsTakenAtOnce()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QCOMPARE(buffer.feed(first, messages), State::Empty);
    QCOMPARE(messages, QList<QByteArray>{first});
}

void ModbusMessageBufferTest::severalMessagesAtOnceAreTakenInOrder()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QCOMPARE(buffer.feed(first + second + first, messages), State::Empty);
    QCOMPARE(messages, (QList<QByteArray>{first, second, first}));
}

void ModbusMessageBufferTest::aMessageInPiecesIsTakenWithItsLastByte()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    for (qsizetype i = 0; i < first.size() - 1; ++i) {
        QCOMPARE(buffer.feed(first.mid(i, 1), messages), State::Waiting);
        QVERIFY(messages.isEmpty());
    }
    QCOMPARE(buffer.feed(first.right(1), messages), State::Empty);
    QCOMPARE(messages, QList<QByteArray>{first});
}

void ModbusMessageBufferTest::bytesThatDoNotAddUpAreKeptUntilDiscarded()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QCOMPARE(buffer.feed(first + "xy", messages), State::Waiting); // longer than its length field says
    QVERIFY(messages.isEmpty());
    buffer.discard();
    QCOMPARE(buffer.feed(second, messages), State::Empty);
    QCOMPARE(messages, QList<QByteArray>{second});
    messages.clear();
    QCOMPARE(buffer.feed(first + second.left(5), messages), State::Waiting);
    QCOMPARE(buffer.feed(second.mid(5), messages), State::Empty);
    QCOMPARE(messages, (QList<QByteArray>{first, second}));
}

void ModbusMessageBufferTest::foreignProtocolsAndShortMessagesAreLeftOut_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("protocol 1") << hex("0001 0001 0006 01 03 0064 0002");
    QTest::newRow("protocol 100h") << hex("0001 0100 0006 01 03 0064 0002");
    QTest::newRow("eleven bytes") << hex("0001 0000 0005 01 03 0064 00");
    QTest::newRow("length 0") << hex("0001 0000 0000");
    QTest::newRow("only a function") << hex("0001 0000 0002 01 07");
}

void ModbusMessageBufferTest::foreignProtocolsAndShortMessagesAreLeftOut()
{
    QFETCH(QByteArray, bytes);
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QCOMPARE(buffer.feed(bytes, messages), State::Empty);
    QVERIFY(messages.isEmpty());
    QCOMPARE(buffer.feed(first + bytes + second, messages), State::Empty);
    QCOMPARE(messages, (QList<QByteArray>{first, second}));
}

void ModbusMessageBufferTest::moreThan270BytesAreOverlong()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QCOMPARE(buffer.feed(hex("0001 0000 0109"), messages),
             State::Overlong); // 6 + 265 = 271, as soon as it says so
    ModbusMessageBuffer another;
    QCOMPARE(another.feed(hex("0001 0000 ffff"), messages), State::Overlong);
    QVERIFY(messages.isEmpty());
}

void ModbusMessageBufferTest::anUnfinishedBufferBeyond270BytesIsOverlong()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    QByteArray many;
    for (int i = 0; i < 23; ++i)
        many += first; // 276 bytes
    QCOMPARE(buffer.feed(many, messages), State::Empty);
    QCOMPARE(messages.size(), 23);
    QCOMPARE(buffer.feed(many + 'x', messages), State::Overlong);
    QCOMPARE(messages.size(), 23);
}

void ModbusMessageBufferTest::aLongestMessageIsTaken()
{
    ModbusMessageBuffer buffer;
    QList<QByteArray> messages;
    const QByteArray longest = hex("0001 0000 0108") + QByteArray(264, '\x10');
    QCOMPARE(longest.size(), 270);
    QCOMPARE(buffer.feed(longest.left(200), messages), State::Waiting);
    QCOMPARE(buffer.feed(longest.mid(200), messages), State::Empty);
    QCOMPARE(messages, QList<QByteArray>{longest});
}

QTEST_APPLESS_MAIN(ModbusMessageBufferTest)
#include "tst_modbus_message_buffer.moc"
