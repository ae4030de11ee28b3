#include "frames.h"
#include "message_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace lds::ui;
using lds::ports::Direction;
using lds::ports::FrameMeaning;

class MessageModelTest : public QObject {
    Q_OBJECT

private:
    static QString text(const MessageModel& model, int row, int column)
    {
        return model.index(row, column).data().toString();
    }

private Q_SLOTS:
    void aBatchIsOneChangeAndPollsAreHidden()
    {
        MessageModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
        model.append({read(400101, 400171), poll(), pollAnswer(), refused()});
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.store().size(), 4);
        model.append({poll(), pollAnswer()});
        QCOMPARE(inserted.count(), 1);
    }

    void aRowTellsTimeWayRoundTripSentenceBytesAndSensor()
    {
        MessageModel model;
        auto answer = frame(FrameMeaning::Written, {QStringLiteral("400103"), QStringLiteral("400104")},
                            Direction::Received);
        answer.roundTripNs = 1'849'000;
        model.append({read(400101, 400171), answer});
        QCOMPARE(text(model, 0, MessageModel::TimeColumn),
                 QDateTime::fromMSecsSinceEpoch(1'700'000'000'000).toString(QStringLiteral("HH:mm:ss.zzz")));
        QCOMPARE(text(model, 0, MessageModel::DirectionColumn), QStringLiteral("→"));
        QCOMPARE(text(model, 1, MessageModel::DirectionColumn), QStringLiteral("←"));
        QCOMPARE(model.index(1, MessageModel::DirectionColumn).data(Qt::AccessibleTextRole).toString(),
                 QStringLiteral("received"));
        QCOMPARE(text(model, 0, MessageModel::RoundTripColumn), QString());
        QCOMPARE(text(model, 1, MessageModel::RoundTripColumn), QStringLiteral("1.8"));
        QCOMPARE(text(model, 0, MessageModel::MessageColumn), QStringLiteral("read 400101–400171"));
        QCOMPARE(text(model, 0, MessageModel::BytesColumn),
                 QStringLiteral("00 01 00 00 00 06 01 03 00 64 00 47"));
        QCOMPARE(text(model, 0, MessageModel::SensorColumn), QStringLiteral("modbus-tcp://127.0.0.1:502"));
        QVERIFY(model.index(0, MessageModel::BytesColumn)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("reconstructed")));
        QVERIFY(model.index(1, MessageModel::BytesColumn).data(Qt::ToolTipRole).toString().isEmpty());
    }

    void theFilterLooksAtWordsBytesAndSensor_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("rows");
        QTest::newRow("nothing") << QString() << 3;
        QTest::newRow("word") << QStringLiteral("REFUSED") << 1;
        QTest::newRow("register") << QStringLiteral("400171") << 1;
        QTest::newRow("two words, any order") << QStringLiteral("400171 read") << 1;
        QTest::newRow("bytes") << QStringLiteral("de ad BE") << 1;
        QTest::newRow("sensor") << QStringLiteral("127.0.0.2") << 1;
        QTest::newRow("nowhere") << QStringLiteral("zebra") << 0;
    }
    void theFilterLooksAtWordsBytesAndSensor()
    {
        QFETCH(QString, text);
        MessageModel model;
        auto other = frame(FrameMeaning::Unknown);
        other.bytes = QByteArray::fromHex("deadbeef");
        other.peer = QStringLiteral("modbus-tcp://127.0.0.2:502");
        model.append({read(400101, 400171), refused(), other});
        MessageFilter filter = model.filter();
        filter.text = text;
        model.setFilter(filter);
        QTEST(model.rowCount(), "rows");
        const int before = model.rowCount();
        model.append({read(400101, 400171), refused(), other}); // arriving messages are judged alike
        QCOMPARE(model.rowCount(), 2 * before);
    }

    void choicesNarrowWhatIsShown()
    {
        MessageModel model;
        auto other = refused();
        other.peer = QStringLiteral("modbus-tcp://127.0.0.2:502");
        model.append({poll(), read(400101, 400101), refused(), other, frame(FrameMeaning::Disconnected),
                      frame(FrameMeaning::Disconnected, {QStringLiteral("reset")}),
                      frame(FrameMeaning::NoAnswer, {QStringLiteral("1000")}),
                      frame(FrameMeaning::Malformed, {QStringLiteral("short")})});
        QCOMPARE(model.rowCount(), 7);
        MessageFilter filter;
        filter.failuresOnly = true;
        model.setFilter(filter);
        QCOMPARE(model.rowCount(), 5);
        filter.thisSensorOnly = true;
        filter.peer = QStringLiteral("modbus-tcp://127.0.0.1:502");
        model.setFilter(filter);
        QCOMPARE(model.rowCount(), 4);
        model.setFilter({{}, {}, false, false, false});
        QCOMPARE(model.rowCount(), 8);
    }

    void trimmedMessagesLeaveTheirRows()
    {
        MessageModel model({40, 20, 1 << 24, 1 << 24});
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setFilter({{}, {}, false, false, false});
        for (int i = 0; i < 300; ++i)
            model.append({read(400101, 400101 + i), poll(), pollAnswer()});
        QVERIFY(model.rowCount() <= 60);
        QCOMPARE(model.rowCount(), int(model.store().size()));
        QCOMPARE(qulonglong(model.rowCount()) + model.store().trimmed(), 900);
        for (int row = 1; row < model.rowCount(); ++row)
            QVERIFY(model.keyAt(row - 1).sequence < model.keyAt(row).sequence);
        // Every row still finds its own message, and the newest is there.
        QCOMPARE(model.frameAt(model.rowCount() - 3).arguments.last(), QStringLiteral("400400"));
        model.clear();
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.store().trimmed(), 0);
    }

    void aRowIsFoundAgainAfterFiltering()
    {
        MessageModel model;
        model.append({read(400101, 400101), refused(), read(400103, 400104)});
        const auto key = model.keyAt(1);
        MessageFilter filter = model.filter();
        filter.failuresOnly = true;
        model.setFilter(filter);
        QCOMPARE(model.rowOf(key), std::optional(0));
        filter.text = QStringLiteral("zebra");
        model.setFilter(filter);
        QCOMPARE(model.rowOf(key), std::nullopt);
    }

    void longMessagesAreShortenedInTheRowOnly()
    {
        MessageModel model;
        auto large = frame(FrameMeaning::Unknown);
        large.bytes = QByteArray(5000, '\x5a');
        model.append({large});
        QVERIFY(text(model, 0, MessageModel::BytesColumn).size() < 400);
        QCOMPARE(model.frameAt(0).bytes.size(), 5000);
    }
};

QTEST_GUILESS_MAIN(MessageModelTest)
#include "tst_message_model.moc"
