#include "message_model.h"
#include "messages_page.h"

#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTextEdit>
#include <QtTest>
#include <thread>

using namespace lds;
using namespace lds::ui;
using ports::Direction;
using ports::Frame;
using ports::FrameMeaning;

namespace {

Frame frame(FrameMeaning meaning, const QStringList& arguments, Direction direction = Direction::Sent)
{
    Frame result;
    result.wallMs = 1'700'000'000'000;
    result.meaning = meaning;
    result.arguments = arguments;
    result.direction = direction;
    result.bytes = QByteArray::fromHex("000100000006010300640047");
    result.reconstructedPrefix = direction == Direction::Sent ? 7 : 0;
    result.roundTripNs = direction == Direction::Received ? 1'800'000 : -1;
    result.protocol = QStringLiteral("Modbus TCP");
    result.peer = QStringLiteral("modbus-tcp://127.0.0.1:502");
    return result;
}

Frame read(int first, int last)
{
    return frame(FrameMeaning::Read, {QString::number(first), QString::number(last)});
}

} // namespace

/// The messages page with real mouse and key events.
class MessagesFlow : public QObject {
    Q_OBJECT

private:
    struct Fixture {
        MessageLog log;
        MessagesPage page{log};
        QTableView* table = page.findChild<QTableView*>();
        QLineEdit* filter = page.findChild<QLineEdit*>();

        Fixture()
        {
            page.resize(1000, 600);
            page.show();
            if (!QTest::qWaitForWindowExposed(&page))
                qFatal("no window");
        }
        int rows() const { return page.model().rowCount(); }
        QPushButton* button(const QString& text) const
        {
            for (auto* candidate : page.findChildren<QPushButton*>()) {
                if (candidate->text() == text)
                    return candidate;
            }
            return nullptr;
        }
        void toggle(const QString& text) const
        {
            for (auto* candidate : page.findChildren<QCheckBox*>()) {
                if (candidate->text() == text) {
                    candidate->setFocus();
                    QTest::keyClick(candidate, Qt::Key_Space);
                    return;
                }
            }
            QFAIL("no such choice");
        }
        bool says(const QString& text) const
        {
            for (const QLabel* label : page.findChildren<QLabel*>()) {
                if (label->isVisible() && label->text().contains(text))
                    return true;
            }
            return false;
        }
        void fill(int count)
        {
            for (int i = 0; i < count; ++i)
                log.record(read(400101, 400101 + i));
            QTRY_COMPARE(rows(), count);
        }
    };

private Q_SLOTS:
    void messagesOfAnotherThreadArriveInWords()
    {
        Fixture f;
        std::thread link([&] {
            f.log.record(read(400101, 400171));
            f.log.record(frame(FrameMeaning::Refused, {QStringLiteral("0x03"), QStringLiteral("0x03")},
                               Direction::Received));
        });
        link.join();
        QTRY_COMPARE(f.rows(), 2);
        const auto text = [&](int row, int column) {
            return f.table->model()->index(row, column).data().toString();
        };
        QCOMPARE(text(0, MessageModel::MessageColumn), QStringLiteral("read 400101–400171"));
        QVERIFY(text(1, MessageModel::MessageColumn).startsWith(QStringLiteral("refused")));
        QVERIFY(f.says(QStringLiteral("2 of 2 shown")));
    }

    void anEmptyListSaysWhy()
    {
        Fixture f;
        QVERIFY(f.says(QStringLiteral("No messages yet")));
        f.fill(2);
        QVERIFY(!f.says(QStringLiteral("No messages yet")));
        f.toggle(QStringLiteral("Failures only"));
        QVERIFY(f.says(QStringLiteral("None of the recorded messages")));
    }

    void theSensorsColumnAppearsWithTheSecondSensor()
    {
        Fixture f;
        f.fill(2);
        QVERIFY(f.table->isColumnHidden(MessageModel::SensorColumn));
        Frame other = read(400101, 400101);
        other.peer = QStringLiteral("modbus-tcp://127.0.0.2:502");
        f.log.record(other);
        QTRY_COMPARE(f.rows(), 3);
        QVERIFY(!f.table->isColumnHidden(MessageModel::SensorColumn));
    }

    void rowsStayInPlaceWhenOlderOnesGo()
    {
        Fixture f;
        f.toggle(QStringLiteral("Hide polls"));
        const MessageStore::Bounds bounds;
        for (int i = 0; i < bounds.polls; ++i)
            f.log.record(read(400011, 400022));
        QTRY_COMPARE(f.rows(), bounds.polls);
        QScrollBar* bar = f.table->verticalScrollBar();
        QTRY_COMPARE(bar->value(), bar->maximum());
        bar->setValue(5000);
        const auto looked = f.page.model().keyAt(5000);
        for (int i = 0; i < 100; ++i)
            f.log.record(read(400011, 400022));
        QTRY_VERIFY(f.rows() < bounds.polls);
        QCOMPARE(f.page.model().rowOf(looked), std::optional(bar->value()));
    }

    void typingFiltersAndTheChoicesNarrow()
    {
        Fixture f;
        f.log.record(read(400101, 400171));
        f.log.record(read(400011, 400022));
        f.log.record(frame(FrameMeaning::NoAnswer, {QStringLiteral("1000")}, Direction::Received));
        QTRY_COMPARE(f.rows(), 2);
        f.toggle(QStringLiteral("Hide polls"));
        QCOMPARE(f.rows(), 3);
        f.toggle(QStringLiteral("Failures only"));
        QCOMPARE(f.rows(), 1);
        f.toggle(QStringLiteral("Failures only"));
        QTest::keySequence(&f.page, QKeySequence::Find);
        QTRY_VERIFY(f.filter->hasFocus());
        QTest::keyClicks(f.filter, QStringLiteral("400171"));
        QTRY_COMPARE(f.rows(), 1);
        QVERIFY(f.says(QStringLiteral("1 of 3 shown")));
    }

    void thisSensorOnlyHidesTheOthers()
    {
        Fixture f;
        Frame other = read(400101, 400101);
        other.peer = QStringLiteral("modbus-tcp://127.0.0.2:502");
        f.log.record(other);
        f.log.record(read(400103, 400104));
        QTRY_COMPARE(f.rows(), 2);
        f.page.setPeer(QStringLiteral("modbus-tcp://127.0.0.1:502"));
        QCOMPARE(f.rows(), 2);
        f.toggle(QStringLiteral("This sensor only"));
        QCOMPARE(f.rows(), 1);
        f.page.setPeer(QStringLiteral("modbus-tcp://127.0.0.2:502"));
        QCOMPARE(f.page.model().frameAt(0).arguments.last(), QStringLiteral("400101"));
    }

    void pauseHoldsTheListAndGoesOnWithoutLoss()
    {
        Fixture f;
        f.fill(3);
        QTest::mouseClick(f.button(QStringLiteral("Pause")), Qt::LeftButton);
        for (int i = 0; i < 5; ++i)
            f.log.record(read(400101, 400101));
        QTRY_VERIFY(f.says(QStringLiteral("Paused, 5 waiting")));
        QCOMPARE(f.rows(), 3);
        QTest::mouseClick(f.button(QStringLiteral("Pause")), Qt::LeftButton);
        QCOMPARE(f.rows(), 8);
    }

    void theListFollowsOnlyWhileAtItsEnd()
    {
        Fixture f;
        f.fill(200);
        QScrollBar* bar = f.table->verticalScrollBar();
        QTRY_COMPARE(bar->value(), bar->maximum());
        QVERIFY(bar->maximum() > 0);
        bar->setValue(20);
        for (int i = 0; i < 50; ++i)
            f.log.record(read(400101, 400101));
        QTRY_COMPARE(f.rows(), 250);
        QCOMPARE(bar->value(), 20);
        bar->setValue(bar->maximum());
        f.log.record(read(400101, 400101));
        QTRY_COMPARE(f.rows(), 251);
        QTRY_COMPARE(bar->value(), bar->maximum());
        QCOMPARE(f.table->rowAt(f.table->viewport()->height() - 5), 250);
    }

    void selectedMessagesAreCopiedAsLines()
    {
        Fixture f;
        f.fill(3);
        f.table->setFocus();
        f.table->selectRow(0);
        QTest::keyClick(f.table, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keySequence(f.table, QKeySequence::Copy);
        const QStringList lines =
            QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].split(QLatin1Char('\t')).contains(QStringLiteral("read 400101")));
        QVERIFY(lines[0].contains(QStringLiteral("00 01 00 00 00 06 01 03 00 64 00 47")));
    }

    void theSelectedMessageIsShownInFull()
    {
        Fixture f;
        Frame large =
            frame(FrameMeaning::Answer,
                  {QStringLiteral("400101"), QStringLiteral("400171"), QStringLiteral("highSetValue=17500")},
                  Direction::Received);
        large.bytes = QByteArray(200, '\x5a') + QByteArray::fromHex("c0ffee");
        f.log.record(large);
        f.log.record(read(400101, 400171));
        QTRY_COMPARE(f.rows(), 2);
        auto* details = f.page.findChild<QTextEdit*>();
        QTest::mouseClick(f.table->viewport(), Qt::LeftButton, {},
                          f.table->visualRect(f.table->model()->index(0, 3)).center());
        QVERIFY(details->toPlainText().contains(QStringLiteral("highSetValue=17500")));
        QVERIFY(details->toPlainText().contains(QStringLiteral("C0 FF EE")));
        QVERIFY(details->toPlainText().contains(QStringLiteral("1.8 ms")));
        QTest::keyClick(f.table, Qt::Key_Down);
        QVERIFY(details->toPlainText().contains(QStringLiteral("reconstructed")));
        QTest::mouseClick(f.button(QStringLiteral("Clear")), Qt::LeftButton);
        QCOMPARE(f.rows(), 0);
        QVERIFY(details->toPlainText().contains(QStringLiteral("Select a message")));
        QVERIFY(!f.button(QStringLiteral("Clear"))->isEnabled());
    }

    void savingTellsWhereAndAFailureTellsWhy()
    {
        Fixture f;
        f.fill(3);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("messages.txt"));
        QVERIFY(f.page.saveTo(path));
        QVERIFY(f.says(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count('\n'), 4);
        const QString nowhere = folder.filePath(QStringLiteral("none/messages.csv"));
        QVERIFY(!f.page.saveTo(nowhere));
        QVERIFY(f.says(nowhere));
        QVERIFY(f.says(QStringLiteral("Choose another folder")));
    }

    void whatWasRemovedIsCounted()
    {
        Fixture f;
        for (int i = 0; i < MessageLog::mostWaiting + 7; ++i)
            f.log.record(read(400101, 400101));
        QTRY_VERIFY(f.rows() > 0);
        QVERIFY(f.says(QStringLiteral("7 oldest removed")));
    }

    void manyFramesAreOneChangeOfTheTable()
    {
        Fixture f;
        f.toggle(QStringLiteral("Hide polls"));
        QSignalSpy changes(f.table->model(), &QAbstractItemModel::rowsInserted);
        for (int i = 0; i < 2000; ++i)
            f.log.record(read(400011, 400022));
        QTRY_COMPARE(f.rows(), 2000);
        QCOMPARE(changes.count(), 1);
    }
};

QTEST_MAIN(MessagesFlow)
#include "flow_messages.moc"
