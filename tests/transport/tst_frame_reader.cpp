#include "frame_reader.h"

#include <QTest>

using lds::modbus::FrameReader;

class FrameReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cutsAtEveryPlaceGiveTheSameMessages();
    void incompleteMessageIsKept();
    void noModbusHeaderIsAFault_data();
    void noModbusHeaderIsAFault();
};

void FrameReaderTest::cutsAtEveryPlaceGiveTheSameMessages()
{
    const QByteArray first = QByteArray::fromHex("0001 0000 0005 01 03 02 1234");
    const QByteArray second = QByteArray::fromHex("0002 0000 0003 07 83 02");
    const QByteArray stream = first + second;
    for (qsizetype cut = 0; cut <= stream.size(); ++cut) {
        FrameReader reader;
        QList<QByteArray> messages;
        for (const QByteArray& piece : {stream.first(cut), stream.sliced(cut)}) {
            reader.append(piece);
            for (auto frame = reader.next(); frame && *frame; frame = reader.next())
                messages.append((*frame)->bytes);
        }
        QCOMPARE(messages, (QList<QByteArray>{first, second}));
        QVERIFY(reader.incomplete().isEmpty());
    }
}

void FrameReaderTest::incompleteMessageIsKept()
{
    FrameReader reader;
    reader.append(QByteArray::fromHex("0001 0000 0005 01 03 02 12"));
    const auto frame = reader.next();
    QVERIFY(frame && !*frame);
    QCOMPARE(reader.incomplete().size(), 10);
    reader.append(QByteArray::fromHex("34"));
    const auto whole = reader.next();
    QVERIFY(whole && *whole);
    QCOMPARE((*whole)->header.transaction, quint16(1));
    QCOMPARE((*whole)->header.unit, quint8(1));
    QCOMPARE((*whole)->pdu(), QByteArray::fromHex("03 02 1234"));
}

void FrameReaderTest::noModbusHeaderIsAFault_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("protocol") << QByteArray::fromHex("0001 0001 0005 01 03 02 1234");
    QTest::newRow("length 0") << QByteArray::fromHex("0001 0000 0000 01 03 02 1234");
    QTest::newRow("length 1") << QByteArray::fromHex("0001 0000 0001 01 03 02 1234");
    QTest::newRow("length over any PDU") << QByteArray::fromHex("0001 0000 00ff 01 03 02 1234");
    QTest::newRow("another service") << QByteArray("SSH-2.0-OpenSSH_9.2\r\n");
}

void FrameReaderTest::noModbusHeaderIsAFault()
{
    QFETCH(QByteArray, bytes);
    FrameReader reader;
    reader.append(bytes);
    QVERIFY(!reader.next());
}

QTEST_GUILESS_MAIN(FrameReaderTest)
#include "tst_frame_reader.moc"
